// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "osc_error.h"

#include <map>
#include <string>
#include <variant>
#include <vector>

namespace spherewalk::practice {

/// The shooting options of a Theta V: names, values, what they may be. Errors are OscErrors.
class CameraOptions {
  public:
    CameraOptions(int width, bool levelled);

    /// The options and "...Support" companions of these names. readOnly: values that the camera knows.
    Json get(const Json& names, const std::map<std::string, Json>& readOnly) const;

    /// Changes all or none.
    void set(const Json& values);
    void reset();
    /// As a sleep or a restart does: the exposure is forgotten, sleep, volume and language are not.
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

    /// One of a list, or within a range, or anything.
    using Legal = std::variant<std::monostate, std::vector<Json>, Range>;

    void define(const std::string& name, Json initial, Legal legal);
    void check(const std::string& name, const Json& value) const;
    static void checkTogether(std::map<std::string, Json>& values, const Json& changed);

    std::map<std::string, Legal> m_legal;
    std::map<std::string, Json> m_defaults;
    std::map<std::string, Json> m_values;
};

} // namespace spherewalk::practice
