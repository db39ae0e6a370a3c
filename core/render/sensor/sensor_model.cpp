// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/render/sensor.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <span>

namespace spherewalk::render {

namespace {

constexpr std::string_view kAutoExposure = "auto_exposure";
constexpr std::string_view kLineDelay = "line_delay_s";
constexpr std::string_view kGains = "gains";
constexpr std::string_view kKnots = "knots";

/// A value of the model with its place in the YAML and its range.
struct Number {
    std::string_view section;
    std::string_view name;
    double least;
    double most;
};

/// Visits all numbers of a sensor, in the order of the YAML. visit: takes (Number, double&) or, for lists,
/// (Number, std::span<double>). Model: SensorModel, const or not.
template <class Model, class Visit>
void visitNumbers(Model& model, const Visit& visit) {
    constexpr double kAny = std::numeric_limits<double>::infinity();
    auto& exposure = model.exposure;
    visit(Number{"exposure", "time_s", 0, 1}, exposure.timeS);
    visit(Number{"exposure", "reference_time_s", 0, 1}, exposure.referenceTimeS);
    visit(Number{"exposure", "gain_db", -20, 60}, exposure.gainDb);
    if (exposure.automatic) {
        auto& automatic = *exposure.automatic;
        visit(Number{kAutoExposure, "target", 0.001, 1}, automatic.target);
        visit(Number{kAutoExposure, "least_time_s", 1e-6, 1}, automatic.leastTimeS);
        visit(Number{kAutoExposure, "most_time_s", 1e-6, 1}, automatic.mostTimeS);
        visit(Number{kAutoExposure, "most_gain_db", 0, 60}, automatic.mostGainDb);
        visit(Number{kAutoExposure, "response", 0.01, 1}, automatic.response);
    }
    visit(Number{"shutter", kLineDelay, 0, 0.001}, model.shutter.lineDelayS);
    visit(Number{"vignetting", "natural", 0, 1}, model.vignetting.natural);
    visit(Number{"vignetting", "radial", -10, 10}, std::span(model.vignetting.radial));
    visit(Number{"defocus", "diameter_px", 0, 100}, model.defocus.diameterPx);
    visit(Number{"defocus", "aperture_mm", 0, 100}, model.defocus.apertureMm);
    visit(Number{"defocus", "focus_m", 1e-3, 1e6}, model.defocus.focusM);
    visit(Number{"noise", "full_well_e", 0, 1e7}, model.noise.fullWellE);
    visit(Number{"noise", "read_e", 0, 10000}, model.noise.readE);
    visit(Number{"white_balance", "response", 1e-3, 4}, std::span(model.whiteBalance.response));
    visit(Number{"white_balance", kGains, 0, 16}, std::span(model.whiteBalance.gains));
    visit(Number{"tone_curve", "gamma", 0, 10}, model.tone.gamma);
    visit(Number{"tone_curve", kKnots, 0, 1}, std::span(model.tone.knots));
    visit(Number{"depth", "least_m", 0, 1e6}, model.depth.leastM);
    visit(Number{"depth", "most_m", 0, kAny}, model.depth.mostM);
    visit(Number{"depth", "sigma_m", 0, 10}, model.depth.sigmaM);
    visit(Number{"depth", "sigma_per_m", 0, 10}, model.depth.sigmaPerM);
}

[[noreturn]] void refuseSensor(const std::string& why) {
    throw Error(ErrorKind::InvalidInput, text("A sensor cannot have ", why, "."));
}

void checkRange(const Number& number, std::span<const double> values) {
    for (const double value : values) {
        if (!(value >= number.least && value <= number.most)) { // NaN too
            refuseSensor(text(number.section, "/", number.name, " ", value, "; it must be from ",
                              number.least, " to ", number.most));
        }
    }
}

// -------- YAML

/// Reads a section's entries by name, and knows which of them nobody has asked for.
class Sections {
  public:
    Sections(const YAML::Node& root, std::string source) : m_root(root), m_source(std::move(source)) {}

    [[noreturn]] void fail(const std::string& why) const {
        throw Error(ErrorKind::InvalidInput, text("Could not read the sensor ", m_source, ": ", why, "."));
    }

    bool has(std::string_view section) {
        m_known.emplace(section);
        return static_cast<bool>(m_root[std::string(section)]);
    }

    /// The entry of a section, or of the whole with an empty section; undefined if it is not there.
    YAML::Node entry(const std::string& section, const std::string& name) {
        if (section.empty()) {
            m_known.insert(name);
            return m_root[name];
        }
        m_known.insert({section, section + "/" + name});
        const YAML::Node node = m_root[section];
        if (node && !node.IsMap()) {
            fail(text("the entry ", section, " holds no entries"));
        }
        return node ? node[name] : YAML::Node(YAML::NodeType::Undefined);
    }

    template <class Value>
    void read(std::string_view section, std::string_view name, const char* what, Value& value) {
        const YAML::Node node = entry(std::string(section), std::string(name));
        if (!node.IsDefined()) {
            return;
        }
        // yaml-cpp 0.6 takes -1 for the largest of those that have no sign.
        bool isValue = !(std::is_unsigned_v<Value> && node.IsScalar() && node.Scalar().starts_with('-'));
        try {
            value = isValue ? node.as<Value>() : value;
        } catch (const YAML::Exception&) {
            isValue = false;
        }
        if (!isValue) {
            fail(text("the entry ", section, section.empty() ? "" : "/", name, " is not a ", what));
        }
    }

    void readList(std::string_view section, std::string_view name, std::span<double> values) {
        std::vector<double> list(values.begin(), values.end());
        read(section, name, "list of numbers", list);
        if (list.size() != values.size()) {
            fail(text("the entry ", section, "/", name, " has ", list.size(), " numbers, not ",
                      values.size()));
        }
        std::copy(list.begin(), list.end(), values.begin());
    }

    /// Refuses the first entry that nobody has asked for.
    void requireAllKnown() const {
        for (const auto& section : m_root) {
            const auto name = section.first.as<std::string>("");
            require(name);
            if (section.second.IsMap()) {
                for (const auto& entry : section.second) {
                    require(name + "/" + entry.first.as<std::string>(""));
                }
            }
        }
    }

  private:
    void require(const std::string& name) const {
        if (!m_known.contains(name)) {
            std::string list;
            const std::string section = name.substr(0, name.find('/'));
            for (const std::string& known : m_known) {
                if (name == section ? known.find('/') == std::string::npos
                                    : known.starts_with(section + "/")) {
                    list += text(list.empty() ? "" : ", ", known);
                }
            }
            fail(text("the entry ", printable(name), " is unknown; there are ", list));
        }
    }

    YAML::Node m_root;
    std::string m_source;
    std::set<std::string> m_known;
};

SensorModel modelOf(Sections& sections) {
    SensorModel model;
    if (sections.has(kAutoExposure)) {
        model.exposure.automatic.emplace();
    }
    visitNumbers(model, [&]<class Value>(const Number& number, Value&& value) {
        if constexpr (std::is_same_v<std::decay_t<Value>, double>) {
            sections.read(number.section, number.name, "number", value);
        } else if (number.name != kKnots) {
            sections.readList(number.section, number.name, value);
        }
    });
    sections.read("tone_curve", "knots", "list of numbers", model.tone.knots);
    sections.read("shutter", "most_views", "whole number", model.shutter.mostViews);
    sections.read("white_balance", "auto", "yes or no", model.whiteBalance.isAutomatic);
    sections.read("jpeg", "quality", "whole number", model.jpegQuality);
    sections.read("", "seed", "whole number", model.seed);
    sections.requireAllKnown();
    return model;
}

std::vector<double> listOf(double value) {
    return {value};
}

std::vector<double> listOf(std::span<const double> values) {
    return {values.begin(), values.end()};
}

std::string listText(std::span<const double> values) {
    std::string list;
    for (const double value : values) {
        list += text(list.empty() ? "" : ", ", value);
    }
    return text("[", list, "]");
}

} // namespace

void SensorModel::validate() const {
    visitNumbers(*this, []<class Value>(const Number& number, const Value& value) {
        if constexpr (std::is_same_v<Value, double>) {
            checkRange(number, std::span(&value, 1));
        } else {
            checkRange(number, value);
        }
    });
    if (shutter.mostViews < 4 || shutter.mostViews > 1024) {
        refuseSensor(text("shutter/most_views ", shutter.mostViews, "; it must be from 4 to 1024"));
    }
    if (jpegQuality < 0 || jpegQuality > 100) {
        refuseSensor(text("jpeg/quality ", jpegQuality, "; it must be from 1 to 100, or 0 for none"));
    }
    if (noise.readE > 0 && noise.fullWellE <= 0) {
        refuseSensor("noise/read_e without noise/full_well_e: electrons mean nothing without it");
    }
    if (tone.gamma > 0 && tone.gamma < 0.1) {
        refuseSensor(text("tone_curve/gamma ", tone.gamma, "; it must be from 0.1 to 10, or 0 for sRGB"));
    }
    if (tone.knots.size() == 1 || tone.knots.size() > 257 ||
        !std::is_sorted(tone.knots.begin(), tone.knots.end())) {
        refuseSensor("tone_curve/knots that fall, or one or more than 257 of them");
    }
    if (exposure.automatic && exposure.automatic->leastTimeS > exposure.automatic->mostTimeS) {
        refuseSensor("auto_exposure/least_time_s above most_time_s");
    }
    if (depth.leastM > depth.mostM) {
        refuseSensor("depth/least_m above most_m");
    }
}

SensorModel parseSensor(std::string_view yaml, const std::string& source) {
    YAML::Node root;
    try {
        root = YAML::Load(std::string(yaml));
    } catch (const YAML::Exception&) {
        Sections({}, source).fail("it is not valid YAML");
    }
    if (root.IsMap() && root["sensor"]) {
        root.reset(root["sensor"]);
    }
    Sections sections(root, source);
    if (!root.IsMap()) {
        sections.fail("it holds no entries");
    }
    SensorModel model = modelOf(sections);
    try {
        model.validate();
    } catch (const Error& error) {
        throw Error(ErrorKind::InvalidInput,
                    text("Could not use the sensor ", source, ": ", error.sentence()));
    }
    return model;
}

SensorModel readSensor(const std::filesystem::path& file) {
    constexpr std::uint64_t kLargest = 1 << 20;
    return parseSensor(readTextFile(file, kLargest), file.string());
}

std::string sensorYaml(const SensorModel& sensor) {
    std::vector<std::pair<std::string_view, std::string>> sections; // with their entries
    const auto put = [&](std::string_view section, std::string_view name, const std::string& value) {
        if (sections.empty() || sections.back().first != section) {
            sections.emplace_back(section, "");
        }
        sections.back().second += text("    ", name, ": ", value, "\n");
    };
    SensorModel plain;
    if (sensor.exposure.automatic) {
        plain.exposure.automatic.emplace();
    }
    std::vector<std::vector<double>> usual; // what each number is by default
    visitNumbers(plain,
                 [&]<class Value>(const Number&, const Value& value) { usual.push_back(listOf(value)); });
    auto next = usual.begin();
    visitNumbers(sensor, [&]<class Value>(const Number& number, const Value& value) {
        const std::vector<double> list = listOf(value);
        const bool isPlain = list == *next++;
        if (!isPlain || number.section == kAutoExposure) {
            put(number.section, number.name,
                std::is_same_v<Value, double> ? text(list.front()) : listText(list));
        }
        if (number.name == kLineDelay && sensor.shutter.mostViews != plain.shutter.mostViews) {
            put("shutter", "most_views", text(sensor.shutter.mostViews));
        }
        if (number.name == kGains && sensor.whiteBalance.isAutomatic) {
            put("white_balance", "auto", "true");
        }
    });
    if (sensor.jpegQuality > 0) {
        put("jpeg", "quality", text(sensor.jpegQuality));
    }
    std::string yaml = text("sensor:\n  seed: ", sensor.seed, "\n");
    for (const auto& [section, entries] : sections) {
        yaml += text("  ", section, ":\n", entries);
    }
    return yaml;
}

} // namespace spherewalk::render
