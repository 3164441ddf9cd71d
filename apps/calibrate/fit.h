// SPDX-License-Identifier: MIT
// Lines through measured times. Times err by a share of themselves and, now and then, by a lot, because
// somebody else had the machine: residuals are relative, and the worst points have no say.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace apps {

/// y in microseconds, x in whatever the time is fitted over.
struct Point {
    double x = 0;
    double y = 0;
};

struct Line {
    double intercept = 0;
    double slope = 0;
    double r2 = 0;           // of all points, in relative residuals; 0 where a line explains nothing
    double rms_percent = 0;  // relative residuals of all points
    std::size_t used = 0;    // points that were not trimmed
};

struct Quartiles {
    double low = 0;
    double middle = 0;
    double high = 0;
};

/// Zeros for no values; between two values, linear interpolation.
Quartiles quartiles(std::vector<double> values);
double median(std::vector<double> values);

/// The line of least relative squares, (y_i - line(x_i)) / y_i, through what is left when at most a quarter
/// of the points, those far from the Theil-Sen line, are trimmed. Fewer than three points, or a single x: a
/// line with r2 0 and used 0. Points whose y is not positive are left out.
Line fit_line(std::span<const Point> points);

}  // namespace apps
