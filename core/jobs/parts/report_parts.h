// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/base/json_fwd.h"
#include "spherewalk/base/progress.h"

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace spherewalk::jobs {

/// The value, "-" if it is not known, or "lost" if it is infinite.
std::string orDash(const std::optional<double>& value, int digits = 2);

/// The value, or null if it is not known or infinite.
Json orNull(const std::optional<double>& value);

/// The difference a - b, times a factor, on a grey of 128. Range: pictures of one size.
RgbImage difference(const RgbImage& a, const RgbImage& b, int times);

/// Hands on each warning of a job once, though several of its steps give it.
class EachWarningOnce : public ProgressSink {
  public:
    /// Owner: the sink must outlive this.
    explicit EachWarningOnce(ProgressSink& sink) : m_sink(sink) {}

    void progress(double fraction, std::string_view activity) override {
        m_sink.progress(fraction, activity);
    }

    void warning(std::string_view sentence) override {
        if (m_given.emplace(sentence).second) {
            m_sink.warning(sentence);
        }
    }

  private:
    ProgressSink& m_sink;
    std::set<std::string, std::less<>> m_given;
};

} // namespace spherewalk::jobs
