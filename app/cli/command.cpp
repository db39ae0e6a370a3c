// SPDX-License-Identifier: GPL-3.0-or-later
#include "command.h"

#include <utility>

namespace spherewalk::cli {

CLI::App& Commands::add(const std::string& name, const std::string& description, Run run, CLI::App* parent) {
    CLI::App& command = *(parent != nullptr ? parent : &m_app)->add_subcommand(name, description);
    command.add_flag("--json", m_json, "Print one JSON object on standard output");
    command.callback([this, run = std::move(run)] { m_chosen = run; });
    return command;
}

CLI::App& Commands::addGroup(const std::string& name, const std::string& description) {
    CLI::App& group = *m_app.add_subcommand(name, description);
    group.require_subcommand(1);
    return group;
}

} // namespace spherewalk::cli
