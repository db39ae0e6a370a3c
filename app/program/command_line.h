// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace spherewalk::program {

/// An option, a positional argument or a flag of a command. Each function changes what the command line
/// accepts, or what the help says, and returns the same option. Owner: the CommandLine; copies stand for one
/// option.
class Option {
  public:
    explicit Option(CLI::Option& option) : m_option(&option) {}

    const Option& required() const;
    /// The help shows the value that the variable has at this call.
    const Option& showDefault() const;
    /// Range: both ends are accepted.
    const Option& range(int least, int most) const;
    const Option& range(double least, double most) const;
    const Option& notNegative() const;
    const Option& among(const std::vector<std::string>& words) const;
    /// One argument holds several values.
    const Option& separatedBy(char separator) const;
    const Option& count(int values) const;
    const Option& needs(const Option& other) const;
    /// Each use takes one value; several uses give several.
    const Option& oneAUse() const;
    /// The environment's variable gives the value where the command line does not.
    const Option& fromEnvironment(const std::string& variable) const;

  private:
    CLI::Option* m_option;
};

/// A command of a program, or the whole of a program that has one command only. Owner: the CommandLine;
/// copies stand for one command.
class Command {
  public:
    explicit Command(CLI::App& app) : m_app(&app) {}

    /// A command within this one.
    Command command(const std::string& name, const std::string& help) const;
    /// The user must give one of the commands within.
    void requireCommand() const;
    /// Of the options that the result declares, the user must give exactly one.
    Command oneOf(const std::string& name, const std::string& help) const;

    /// name: "--effort", or "survey" for a positional argument. Value: std::string, double, an integer,
    /// std::filesystem::path, std::optional<std::string>, or a vector. Owner: value must outlive the
    /// CommandLine.
    template <class Value>
    Option option(const std::string& name, Value& value, const std::string& help) const;
    /// Value: bool, or a number, for which "--grid{404}" names what the bare flag stands for.
    template <class Value>
    Option flag(const std::string& name, Value& value, const std::string& help) const;

    /// What CommandLine::parse() calls if the user gave this command.
    void onGiven(std::function<void()> then) const;
    /// A flag that is a command of its own: the user gives the flag or a command within.
    void onFlag(const std::string& flag, const std::string& help, std::function<void()> then) const;

  private:
    CLI::App* m_app;
};

/// What a program accepts on its command line.
class CommandLine {
  public:
    /// name: what the help calls the program; empty: as it was called. version: what --version prints; empty:
    /// there is no such flag.
    CommandLine(const std::string& description, const std::string& name, const std::string& version);
    ~CommandLine();
    CommandLine(const CommandLine&) = delete;
    CommandLine& operator=(const CommandLine&) = delete;

    Command program() const { return Command(*m_app); }

    /// Fills the variables and calls the functions of the commands that were given. Returns the exit status
    /// if the program is to end now: after --help and --version, or a usage error, all of which are printed.
    std::optional<int> parse(int argc, char** argv);

    /// The same for words that a program wrote: it neither prints nor helps. Errors: InvalidInput for a
    /// usage error.
    void parse(std::vector<std::string> words);

  private:
    std::unique_ptr<CLI::App> m_app;
};

} // namespace spherewalk::program
