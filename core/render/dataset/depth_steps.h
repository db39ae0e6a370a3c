// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/render/scene_depth.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

namespace spherewalk::render {

/// A photo's depth as its file has it, two bytes a pixel. It is read in a fraction of a millisecond, and what
/// a view does not show is never turned into distances. Threads: const functions may run on any number at a
/// time.
class DepthSteps {
  public:
    explicit DepthSteps(const DepthMap& map);

    /// Errors: as DepthMap::parse() and DepthMap::read().
    static DepthSteps parse(ByteView bytes, std::string_view source);
    static DepthSteps read(const std::filesystem::path& file);

    int width() const { return m_width; }

    int height() const { return m_height; }

    /// The values of a row: twice 1 / distance in steps of DepthMap::kStepPerM, plus 1 where it is sure.
    /// Range: from 2 on.
    const std::uint16_t* row(int y) const {
        return m_values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width);
    }

    /// 1 / distance of such a value, in 1/m.
    static float inverseM(unsigned value) {
        return static_cast<float>(static_cast<int>(value / 2) * DepthMap::kStepPerM);
    }

    static bool isSure(unsigned value) { return value % 2 == 1; }

  private:
    DepthSteps(int width, int height)
        : m_width(width),
          m_height(height),
          m_values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

    int m_width;
    int m_height;
    std::vector<std::uint16_t> m_values;
};

} // namespace spherewalk::render
