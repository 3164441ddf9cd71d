// SPDX-License-Identifier: MIT
#include "context/shared_json_file.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <time.h>
#include <unistd.h>

#include <cstdio>

namespace glext_emu {
namespace {

// A program that is killed loses at most this much.
constexpr std::chrono::milliseconds kLongestDelay{100};
constexpr std::size_t kLargestBuffer = 32'768;

// Neither is ever freed: programs call GL from their own destructors.
struct Files {
    std::mutex mutex;
    SharedJsonFile* first = nullptr;
};

Files& files() {
    static Files* const all = new Files;
    return *all;
}

bool write_all(int file, std::string_view text, off_t at) {
    while (!text.empty()) {
        const ssize_t n = pwrite(file, text.data(), text.size(), at);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return false;
        text.remove_prefix(static_cast<std::size_t>(n));
        at += n;
    }
    return true;
}

bool holds(int file, std::string_view text, off_t at) {
    std::string found(text.size(), '\0');
    const auto size = static_cast<ssize_t>(text.size());
    return pread(file, found.data(), text.size(), at) == size && found == text;
}

// A write beyond the program's file size limit is to fail, not to end the program.
class FileSizeSignalBlocked {
  public:
    FileSizeSignalBlocked() {
        sigemptyset(&signal_);
        sigaddset(&signal_, SIGXFSZ);
        pthread_sigmask(SIG_BLOCK, &signal_, &before_);
    }
    ~FileSizeSignalBlocked() {
        const timespec now{0, 0};
        if (sigismember(&before_, SIGXFSZ) == 0) sigtimedwait(&signal_, nullptr, &now);
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }
    FileSizeSignalBlocked(const FileSizeSignalBlocked&) = delete;
    FileSizeSignalBlocked& operator=(const FileSizeSignalBlocked&) = delete;

  private:
    sigset_t signal_;
    sigset_t before_;
};

// <records> starts with a newline and has commas between its records. Returns what went wrong, or nothing.
// Nothing is written over a file of another kind, and what cannot be written whole is taken back.
std::string append_to_file(int file, const JsonFileKind& kind, const std::string& records) {
    const FileSizeSignalBlocked blocked;
    const auto head = static_cast<off_t>(kind.head.size());
    const auto tail = static_cast<off_t>(kind.tail.size());
    const off_t size = lseek(file, 0, SEEK_END);
    off_t at = 0;
    std::string text;
    if (size == 0) {
        text = kind.head;
    } else {
        at = size - tail;
        if (at < head || !holds(file, kind.head, 0) || !holds(file, kind.tail, at))
            return "is not a " + std::string(kind.name) + ", so nothing is written to it";
        if (at != head) text = ",";
    }
    text += records;
    text += kind.tail;
    if (write_all(file, text, at)) return "";
    // The old brackets take no more room than there was.
    if (ftruncate(file, size) == 0 && size != 0) write_all(file, kind.tail, at);
    return "cannot be written";
}

}  // namespace

std::string json_string(const char* text) {
    std::string out = "\"";
    for (const char* c = text == nullptr ? "" : text; *c != '\0'; ++c) {
        const auto byte = static_cast<unsigned char>(*c);
        if (byte == '"' || byte == '\\') {
            out += '\\';
            out += *c;
        } else if (byte < 0x20 || byte >= 0x7f) {
            char escape[8];
            std::snprintf(escape, sizeof escape, "\\u%04x", byte);
            out += escape;
        } else {
            out += *c;
        }
    }
    return out + '"';
}

SharedJsonFile::SharedJsonFile(std::string path, const JsonFileKind& kind)
    : path_(std::move(path)), kind_(kind), is_wanted_(!path_.empty()) {
    const std::lock_guard lock(files().mutex);
    next_ = files().first;
    files().first = this;
}

SharedJsonFile::~SharedJsonFile() {
    flush();
    const std::lock_guard lock(files().mutex);
    SharedJsonFile** link = &files().first;
    while (*link != this) link = &(*link)->next_;
    *link = next_;
}

void SharedJsonFile::before_fork() {
    files().mutex.lock();
    for (SharedJsonFile* file = files().first; file != nullptr; file = file->next_) file->mutex_.lock();
}

void SharedJsonFile::after_fork(bool is_child) {
    for (SharedJsonFile* file = files().first; file != nullptr; file = file->next_) {
        // The parent writes what happened in the parent.
        if (is_child) {
            file->buffer_.clear();
            ++file->generation_;
        }
        file->mutex_.unlock();
    }
    files().mutex.unlock();
}

void SharedJsonFile::append(std::string_view records) {
    if (!is_wanted()) return;
    const std::lock_guard lock(mutex_);
    buffer_ += buffer_.empty() ? "\n" : ",\n";
    buffer_ += records;
    const auto now = std::chrono::steady_clock::now();
    if (buffer_.size() > kLargestBuffer || now - last_flush_ > kLongestDelay) {
        last_flush_ = now;
        flush_locked();
    }
}

void SharedJsonFile::flush() {
    const std::lock_guard lock(mutex_);
    flush_locked();
}

bool SharedJsonFile::is_idle() {
    const std::unique_lock lock(mutex_, std::try_to_lock);
    return lock.owns_lock();
}

void SharedJsonFile::flush_locked() {
    if (buffer_.empty()) return;
    std::string problem = "cannot be opened";
    const int file = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file >= 0) {
        int locked = -1;
        while ((locked = flock(file, LOCK_EX)) != 0 && errno == EINTR) {
        }
        if (locked == 0) problem = append_to_file(file, kind_, buffer_);
        close(file);
    }
    buffer_.clear();
    if (problem.empty()) return;
    std::fprintf(stderr, "glext_emu: the %s %s %s.\n", std::string(kind_.name).c_str(), path_.c_str(),
                 problem.c_str());
    is_wanted_ = false;
}

}  // namespace glext_emu
