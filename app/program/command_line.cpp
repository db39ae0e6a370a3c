// SPDX-License-Identifier: GPL-3.0-or-later
// The only source that reads CLI11, whose templates take seconds to compile in each source that includes
// them.
#include "program/command_line.h"

#include "program/program.h"

#include "spherewalk/base/error.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <utility>

namespace spherewalk::program {

const Option& Option::required() const {
    m_option->required();
    return *this;
}

const Option& Option::showDefault() const {
    m_option->capture_default_str();
    return *this;
}

const Option& Option::range(int least, int most) const {
    m_option->check(CLI::Range(least, most));
    return *this;
}

const Option& Option::range(double least, double most) const {
    m_option->check(CLI::Range(least, most));
    return *this;
}

const Option& Option::notNegative() const {
    m_option->check(CLI::NonNegativeNumber);
    return *this;
}

const Option& Option::among(const std::vector<std::string>& words) const {
    m_option->check(CLI::IsMember(words));
    return *this;
}

const Option& Option::separatedBy(char separator) const {
    m_option->delimiter(separator);
    return *this;
}

const Option& Option::count(int values) const {
    m_option->expected(values);
    return *this;
}

const Option& Option::needs(const Option& other) const {
    m_option->needs(other.m_option);
    return *this;
}

const Option& Option::oneAUse() const {
    m_option->allow_extra_args(false);
    return *this;
}

const Option& Option::fromEnvironment(const std::string& variable) const {
    m_option->envname(variable);
    return *this;
}

Command Command::command(const std::string& name, const std::string& help) const {
    return Command(*m_app->add_subcommand(name, help));
}

void Command::requireCommand() const {
    m_app->require_subcommand(1);
}

Command Command::oneOf(const std::string& name, const std::string& help) const {
    CLI::Option_group* const group = m_app->add_option_group(name, help);
    group->require_option(1);
    return Command(*group);
}

template <class Value>
Option Command::option(const std::string& name, Value& value, const std::string& help) const {
    return Option(*m_app->add_option(name, value, help));
}

template <class Value>
Option Command::flag(const std::string& name, Value& value, const std::string& help) const {
    return Option(*m_app->add_flag(name, value, help));
}

template Option Command::option(const std::string&, std::string&, const std::string&) const;
template Option Command::option(const std::string&, double&, const std::string&) const;
template Option Command::option(const std::string&, int&, const std::string&) const;
template Option Command::option(const std::string&, std::uint32_t&, const std::string&) const;
template Option Command::option(const std::string&, std::uint64_t&, const std::string&) const;
template Option Command::option(const std::string&, std::filesystem::path&, const std::string&) const;
template Option Command::option(const std::string&, std::optional<std::string>&, const std::string&) const;
template Option Command::option(const std::string&, std::optional<double>&, const std::string&) const;
template Option Command::option(const std::string&, std::vector<int>&, const std::string&) const;
template Option Command::option(const std::string&, std::vector<double>&, const std::string&) const;
template Option Command::option(const std::string&, std::vector<std::string>&, const std::string&) const;
template Option Command::flag(const std::string&, bool&, const std::string&) const;
template Option Command::flag(const std::string&, int&, const std::string&) const;
template Option Command::flag(const std::string&, std::uint64_t&, const std::string&) const;

void Command::onGiven(std::function<void()> then) const {
    m_app->callback(std::move(then));
}

void Command::onFlag(const std::string& flag, const std::string& help, std::function<void()> then) const {
    const CLI::Option* const given = m_app->add_flag(flag, help);
    m_app->require_subcommand(0, 1);
    m_app->callback([app = m_app, given, flag, then = std::move(then)] {
        if (!app->get_subcommands().empty()) {
            return;
        }
        if (given->empty()) {
            throw CLI::RequiredError(flag + " or a subcommand");
        }
        then();
    });
}

CommandLine::CommandLine(const std::string& description, const std::string& name, const std::string& version)
    : m_app(std::make_unique<CLI::App>(description, name)) {
    if (!version.empty()) {
        m_app->set_version_flag("--version", version);
    }
}

CommandLine::~CommandLine() = default;

std::optional<int> CommandLine::parse(int argc, char** argv) {
    try {
        m_app->parse(argc, argv);
        return std::nullopt;
    } catch (const CLI::ParseError& error) {
        return m_app->exit(error) == 0 ? kDone : kUsage;
    }
}

void CommandLine::parse(std::vector<std::string> words) {
    m_app->set_help_flag();
    for (CLI::App* const group : m_app->get_subcommands(nullptr)) {
        group->set_help_flag();
    }
    std::reverse(words.begin(), words.end()); // CLI11 takes them from the end
    try {
        m_app->parse(std::move(words));
    } catch (const CLI::ParseError& error) {
        throw Error(ErrorKind::InvalidInput, error.what());
    }
}

} // namespace spherewalk::program
