// SPDX-License-Identifier: MIT
// A bar on the terminal that stderr is; nothing where it is a pipe or a file.
#pragma once

#include <string>

namespace apps {

class ProgressBar {
  public:
    ProgressBar(std::string what, int steps);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    void step();

  private:
    void show() const;

    std::string what_;
    int steps_;
    int done_ = 0;
    bool is_shown_;
};

}  // namespace apps
