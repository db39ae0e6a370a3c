// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/dataset/bag.h"

namespace spherewalk::dataset {

std::unique_ptr<Bag> makeRosbag(const std::filesystem::path& file);
std::unique_ptr<Bag> makeMcap(const std::filesystem::path& file);

} // namespace spherewalk::dataset
