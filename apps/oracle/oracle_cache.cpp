// SPDX-License-Identifier: MIT
// The cache's file: JSON, {"key": "...", "truths": [{"contested": n, "hash": "...", "visible": [ids]}]}.
#include "apps/oracle/oracle_cache.h"

#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace apps {

namespace {

/// Nothing where the text is not a cache of that key and length.
std::optional<std::vector<std::optional<Truth>>> read(std::istream& in, std::uint64_t key,
                                                      std::size_t frames) {
    try {
        const auto json = nlohmann::json::parse(in);
        if (json.at("key") != std::to_string(key) || json.at("truths").size() != frames) return std::nullopt;
        std::vector<std::optional<Truth>> truths;
        for (const auto& entry : json.at("truths")) {
            Truth truth;
            truth.visible = entry.at("visible").get<std::vector<ObjectId>>();
            truth.contested_pixels = entry.at("contested").get<std::uint32_t>();
            truth.image_hash = std::stoull(entry.at("hash").get<std::string>());
            truths.emplace_back(std::move(truth));
        }
        return truths;
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

}  // namespace

OracleCache::OracleCache(std::filesystem::path file, std::uint64_t key, std::size_t frames)
    : file_(std::move(file)), key_(key), truths_(frames) {
    std::ifstream in(file_);
    if (auto known = read(in, key, frames)) truths_ = std::move(*known);
}

void OracleCache::keep(std::size_t frame, Truth truth) {
    truths_[frame] = std::move(truth);
    is_changed_ = true;
}

void OracleCache::save() const {
    if (!is_changed_) return;
    nlohmann::json truths = nlohmann::json::array();
    for (const std::optional<Truth>& truth : truths_) {
        if (!truth) return;  // an incomplete run leaves nothing behind
        truths.push_back({{"visible", truth->visible},
                          {"contested", truth->contested_pixels},
                          {"hash", std::to_string(truth->image_hash)}});
    }
    std::filesystem::path part = file_;
    part += ".part" + std::to_string(::getpid());
    std::ofstream out(part);
    out << nlohmann::json{{"key", std::to_string(key_)}, {"truths", truths}};
    out.close();
    if (!out) throw std::runtime_error("cannot write " + part.string());
    std::filesystem::rename(part, file_);
}

}  // namespace apps
