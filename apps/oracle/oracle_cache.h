// SPDX-License-Identifier: MIT
// A file of truths, so that runs of the same scene, path, size and driver draw the item buffers once.
#pragma once

#include <filesystem>
#include <optional>

#include "apps/oracle/oracle.h"

namespace apps {

class OracleCache {
  public:
    /// `key` stands for all that the truths depend on; a file with another key, or a damaged one, counts as
    /// empty.
    OracleCache(std::filesystem::path file, std::uint64_t key, std::size_t frames);

    std::optional<Truth> find(std::size_t frame) const { return truths_[frame]; }
    void keep(std::size_t frame, Truth truth);

    /// Writes the file if anything was kept; a reader never sees a half-written one.
    void save() const;

  private:
    std::filesystem::path file_;
    std::uint64_t key_;
    std::vector<std::optional<Truth>> truths_;
    bool is_changed_ = false;
};

}  // namespace apps
