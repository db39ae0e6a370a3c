// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

namespace spherewalk::render {

/// What the library knows of a struct of the C interface that begins with struct_size: kName; kSizes, all
/// sizes that it has had, oldest first, the last one today's; and defaults(), with today's size. Members are
/// only ever added, at the end, and there is no padding at the end.
///
/// The caller's struct may be smaller than today's, so it is only ever a pointer here: a reference tells the
/// compiler that there is a whole one.
template <class Struct>
struct CStruct;

/// Errors: InvalidInput for a size that no version of the struct has had.
template <class Struct>
void checkStructSize(std::size_t size) {
    static_assert(CStruct<Struct>::kSizes.back() == sizeof(Struct));
    const auto& sizes = CStruct<Struct>::kSizes;
    if (std::find(sizes.begin(), sizes.end(), size) != sizes.end()) {
        return;
    }
    const char* name = CStruct<Struct>::kName;
    throw Error(ErrorKind::InvalidInput,
                size > sizeof(Struct)
                    ? text("A ", name, " has the struct_size ", size, ", and this library knows it up to ",
                           sizeof(Struct),
                           "; use a library as new as the header that the program was compiled with.")
                    : text("A ", name, " has the struct_size ", size, ", which no version of it has had; ",
                           "make it ready with ", name, "_init()."));
}

/// The size of the caller's struct. Errors: InvalidInput for NULL and for an unknown size.
template <class Struct>
std::size_t checkedSize(const Struct* callers) {
    if (callers == nullptr) {
        throw Error(ErrorKind::InvalidInput,
                    text("The ", CStruct<Struct>::kName, " is NULL, which it must not be."));
    }
    std::size_t size = 0;
    std::memcpy(&size, callers, sizeof size);
    checkStructSize<Struct>(size);
    return size;
}

/// The caller's struct as today's, with defaults for the members that its version has not.
template <class Struct>
Struct taken(const Struct* callers) {
    const std::size_t size = checkedSize(callers);
    Struct result = CStruct<Struct>::defaults();
    std::memcpy(&result, callers, size);
    result.struct_size = sizeof(Struct);
    return result;
}

/// As taken(); the defaults for NULL.
template <class Struct>
Struct takenOrDefaults(const Struct* callers) {
    return callers == nullptr ? CStruct<Struct>::defaults() : taken(callers);
}

/// Gives the caller those members that its version of the struct has.
template <class Struct>
void give(Struct today, Struct* callers) {
    const std::size_t size = checkedSize(callers);
    today.struct_size = size;
    std::memcpy(callers, &today, size);
}

} // namespace spherewalk::render
