// SPDX-License-Identifier: GPL-3.0-or-later
#include "page_files.h"

#include "spherewalk/base/json.h"
#include "spherewalk/web/page.h"

namespace spherewalk::web {

namespace {

Json english() {
    return parseJson(pageFile("words.json"), "words.json");
}

} // namespace

std::string word(std::string_view key) {
    return english().at(std::string(key)).get<std::string>();
}

Json allWords(const PageWords& words) {
    Json result = english();
    for (auto& [key, value] : result.items()) {
        value = words(value.get<std::string>());
    }
    return result;
}

} // namespace spherewalk::web
