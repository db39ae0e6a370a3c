// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "device/osc_protocol.h"

#include <map>
#include <string>
#include <variant>
#include <vector>

namespace spherewalk::practice {

/// The options of a Theta V with their values and what these may be. Errors: OscError.
class CameraOptions {
  public:
    CameraOptions(int width, bool levelled);

    /// The values of these options, and of their "...Support" companions. readOnly: options that nobody can
    /// set.
    Json get(const Json& names, const std::map<std::string, Json>& readOnly) const;

    /// Changes all of these options, or none.
    void set(const Json& values);
    /// Restores all values but the clock.
    void reset();
    /// Restores the values of the exposure, as a sleep or a restart does. Sleep, volume and language stay.
    void forgetExposure();
    /// The values that make up the exposure.
    Json exposure() const;

    const Json& value(const std::string& name) const { return m_values.at(name); }

  private:
    struct Range {
        double least;
        double most;
        double step;
        std::string leastName;
        std::string mostName;
    };

    /// Any value, one of a list, or a number within a range.
    using Legal = std::variant<std::monostate, std::vector<Json>, Range>;

    void define(const std::string& name, Json initial, Legal legal);
    void check(const std::string& name, const Json& value) const;
    static void checkTogether(std::map<std::string, Json>& values, const Json& changed);

    std::map<std::string, Legal> m_legal;
    std::map<std::string, Json> m_defaults;
    std::map<std::string, Json> m_values;
};

} // namespace spherewalk::practice
