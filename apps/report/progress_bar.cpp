// SPDX-License-Identifier: MIT
// One line, written over itself and wiped at the end: what stays on the terminal is the summary.
#include "apps/report/progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace apps {

ProgressBar::ProgressBar(std::string what, int steps)
    : what_(std::move(what)), steps_(steps), is_shown_(isatty(STDERR_FILENO) == 1) {
    show();
}

ProgressBar::~ProgressBar() {
    if (is_shown_) fmt::print(stderr, "\r\033[K");
}

void ProgressBar::step() {
    ++done_;
    show();
}

void ProgressBar::show() const {
    if (!is_shown_) return;
    constexpr int kWidth = 40;
    const int full = steps_ > 0 ? kWidth * done_ / steps_ : kWidth;
    fmt::print(stderr, "\r{:<16} [{:#<{}}{:.<{}}] {}/{}", what_, "", full, "", kWidth - full, done_, steps_);
    std::fflush(stderr);
}

}  // namespace apps
