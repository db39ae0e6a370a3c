// SPDX-License-Identifier: Apache-2.0
// Input: a dataset.json. What is accepted is accepted again when it is written.
#include "spherewalk/base/bytes.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/render/dataset_format.h"

#include <cstdlib>

using namespace spherewalk;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    render::DatasetInfo info;
    try {
        info = render::parseDatasetInfo(parseJson(textOf({data, size}), "input", {1 << 20, 32}), "input");
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::Corrupt && error.kind() != ErrorKind::Unsupported) {
            std::abort();
        }
        return 0;
    }
    render::parseDatasetInfo(render::toJson(info), "written");
    return 0;
}
