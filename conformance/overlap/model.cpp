// SPDX-License-Identifier: MIT
// The machine of the texts.
#include "overlap/model.h"

#include <array>

namespace conformance {

namespace {

// NV's queries are those of SAMPLES_PASSED.
GLenum slot_of(const Way& way) {
    return way.target ? way.target : GL_SAMPLES_PASSED;
}

constexpr std::size_t kStackDepth = 16;  // at least; the sequences do not go deeper

}  // namespace

std::string describe(const Command& command) {
    constexpr std::array<const char*, 13> kNames = {
        "draw", "begin",     "end",         "enable",      "disable",   "push",         "pop",
        "call", "read flag", "read result", "delete name", "condition", "end condition"};
    const auto verb = static_cast<std::size_t>(command.verb);
    return std::string(kNames[verb]) + " " + command.way.name + " " + std::to_string(command.number) + "; ";
}

GLenum Model::execute(const Command& command) {
    returned = kUntouched;
    switch (command.verb) {
        case Verb::kDraw:
            if (draws_ && (enabled_ || slot_ != 0)) counter_ += 8 * command.number;
            return GL_NO_ERROR;
        case Verb::kBegin:
            return begin(command.way, command.number);
        case Verb::kEnd:
            return end(command.way);
        case Verb::kEnable:
            enabled_ = true;
            return GL_NO_ERROR;
        case Verb::kDisable:
            enabled_ = false;
            return GL_NO_ERROR;
        case Verb::kPush:
            if (stack_.size() == kStackDepth) return GL_STACK_OVERFLOW;
            stack_.push_back(enabled_);
            return GL_NO_ERROR;
        case Verb::kPop:
            if (stack_.empty()) return GL_STACK_UNDERFLOW;
            enabled_ = stack_.back();
            stack_.pop_back();
            return GL_NO_ERROR;
        case Verb::kCall:
            return call(command.number);
        case Verb::kReadFlag:
            // NV 6.1.13: the result "is reset to FALSE and the pixel counter is reset to zero as a side
            // effect."
            returned = counter_ != 0;
            counter_ = 0;
            return GL_NO_ERROR;
        case Verb::kReadResult:
            return read_result(command.way, command.number);
        case Verb::kDelete:
            return remove(command.way, command.number);
        case Verb::kCondition:
            return condition(command.number);
        case Verb::kUncondition:
            if (!in_block_) return GL_INVALID_OPERATION;
            in_block_ = false;
            draws_ = true;
            block_query_ = 0;
            return GL_NO_ERROR;
    }
    return GL_NO_ERROR;
}

GLenum Model::begin(const Way& way, GLuint name) {
    const auto found = objects_.find(name);
    const bool of_other_type = found != objects_.end() && found->second.boolean != way.boolean;
    if (slot_ != 0 || name == 0 || of_other_type || name == block_query_) {
        return GL_INVALID_OPERATION;
    }
    objects_[name] = {.boolean = way.boolean, .result = 0};
    active_ = name;
    slot_ = slot_of(way);
    active_object_ = objects_[name];
    counter_ = 0;
    return GL_NO_ERROR;
}

GLenum Model::end(const Way& way) {
    if (slot_ == 0 || slot_ != slot_of(way)) return GL_INVALID_OPERATION;
    const std::uint64_t result = active_object_.boolean ? std::uint64_t{counter_ != 0} : counter_;
    // A name that was deleted meanwhile takes its object along.
    if (const auto found = objects_.find(active_); found != objects_.end()) found->second.result = result;
    slot_ = 0;
    active_ = 0;
    return GL_NO_ERROR;
}

GLenum Model::read_result(const Way&, GLuint name) {
    const auto found = objects_.find(name);
    if (found == objects_.end() || (slot_ != 0 && name == active_)) return GL_INVALID_OPERATION;
    returned = static_cast<GLuint>(found->second.result);
    return GL_NO_ERROR;
}

GLenum Model::remove(const Way& way, GLuint name) {
    // NV, Errors, and ARB 4.1.6A: no name goes while a query is active. GL 3.0 dropped that of DeleteQueries.
    if (slot_ != 0 && (names_are_fixed_ || way.target == 0)) return GL_INVALID_OPERATION;
    objects_.erase(name);
    return GL_NO_ERROR;
}

GLenum Model::condition(GLuint name) {
    if (in_block_) return GL_INVALID_OPERATION;
    const auto found = objects_.find(name);
    if (found == objects_.end()) return GL_INVALID_VALUE;
    if (slot_ != 0 && name == active_) return GL_INVALID_OPERATION;
    in_block_ = true;
    draws_ = found->second.result != 0;
    block_query_ = name;
    return GL_NO_ERROR;
}

GLenum Model::call(GLuint list) {
    GLenum first = GL_NO_ERROR;
    for (const Command& command : lists[list]) {
        const GLenum error = execute(command);
        if (first == GL_NO_ERROR) first = error;
    }
    return first;
}

}  // namespace conformance
