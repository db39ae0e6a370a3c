// SPDX-License-Identifier: Apache-2.0
#pragma once

#ifdef __cplusplus
extern "C" {
#endif

/// A whole session of a C program with this dataset and camera-info YAML: opens, lists, renders, streams,
/// gives back. NULL if all went well; else what did not.
const char* spherewalkC99Session(const char* folder, const char* yaml);

#ifdef __cplusplus
}
#endif
