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

void Commands::addFlag(CLI::App& group, const std::string& flag, const std::string& description, Run run) {
    const CLI::Option* given = group.add_flag(flag, description);
    group.add_flag("--json", m_json, "Print one JSON object on standard output");
    group.require_subcommand(0, 1);
    group.callback([this, &group, given, flag, run = std::move(run)] {
        if (!group.get_subcommands().empty()) {
            return;
        }
        if (given->empty()) {
            throw CLI::RequiredError(flag + " or a subcommand");
        }
        m_chosen = run;
    });
}

} // namespace spherewalk::cli
