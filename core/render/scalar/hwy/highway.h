// SPDX-License-Identifier: Apache-2.0
// The part of Highway's interface that the render library uses, one value at a time, in plain C++. It stands
// in where Highway is not installed or is too old: views have the same pixels and take longer. Where Highway
// is found, its own header is used.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>
#include <vector>

#define HWY_AVX3 (1LL << 6)
#define HWY_AVX2 (1LL << 9)
#define HWY_SSE4 (1LL << 11)
#define HWY_SSSE3 (1LL << 12)
#define HWY_EMU128 (1LL << 61)
#define HWY_SCALAR (1LL << 62)
#define HWY_TARGET HWY_SCALAR
#define HWY_TARGETS HWY_SCALAR
#define HWY_ARCH_X86 0
#define HWY_HAVE_SCALABLE 0
#define HWY_ONCE 1
#define HWY_NAMESPACE N_SCALAR
#define HWY_BEFORE_NAMESPACE() static_assert(true, "")
#define HWY_AFTER_NAMESPACE() static_assert(true, "")
#define HWY_EXPORT(function) static_assert(true, "")
#define HWY_DYNAMIC_DISPATCH(function) N_SCALAR::function
#define HWY_STATIC_DISPATCH(function) N_SCALAR::function
#define HWY_INLINE inline
#define HWY_ALIGN alignas(16)

namespace hwy {

inline const char* TargetName(std::int64_t) {
    return "SCALAR";
}

inline std::int64_t SupportedTargets() {
    return HWY_SCALAR;
}

inline std::vector<std::int64_t> SupportedAndGeneratedTargets() {
    return {HWY_SCALAR};
}

inline void SetSupportedTargetsForTest(std::int64_t) {
}

/// There is one target, and nothing to choose.
struct ChosenTarget {
    void Update(std::int64_t) {}
};

inline ChosenTarget GetChosenTarget() {
    return {};
}

inline void Prefetch(const void* at) {
    __builtin_prefetch(at);
}

} // namespace hwy

namespace hwy::N_SCALAR {

/// The tag of vectors of one value.
template <class T>
struct One {
    using Value = T;
};

template <class T>
struct Vec1 {
    T raw;
};

template <class T>
struct Mask1 {
    bool raw;
};

template <class D>
using TFromD = typename D::Value;
template <class D>
using Vec = Vec1<TFromD<D>>;
template <class D>
using Mask = Mask1<TFromD<D>>;
template <class T>
using ScalableTag = One<T>;
template <class T, std::size_t>
using CappedTag = One<T>;
template <class T, class>
using Rebind = One<T>;
template <class D>
using RebindToSigned = One<std::make_signed_t<TFromD<D>>>;

template <class D>
constexpr std::size_t Lanes(D) {
    return 1;
}

template <class D>
constexpr std::size_t MaxLanes(D) {
    return 1;
}

template <class D, class T>
Vec<D> Set(D, T value) {
    return {static_cast<TFromD<D>>(value)};
}

template <class D>
Vec<D> Zero(D) {
    return {TFromD<D>(0)};
}

template <class D, class T>
Vec<D> Iota(D, T first) {
    return {static_cast<TFromD<D>>(first)};
}

template <class D>
Vec<D> LoadU(D, const TFromD<D>* from) {
    return {*from};
}

template <class D>
void StoreU(Vec<D> v, D, TFromD<D>* to) {
    *to = v.raw;
}

template <class D>
void StoreInterleaved3(Vec<D> a, Vec<D> b, Vec<D> c, D, TFromD<D>* to) {
    to[0] = a.raw;
    to[1] = b.raw;
    to[2] = c.raw;
}

template <class D>
void StoreInterleaved4(Vec<D> a, Vec<D> b, Vec<D> c, Vec<D> e, D d, TFromD<D>* to) {
    StoreInterleaved3(a, b, c, d, to);
    to[3] = e.raw;
}

template <class D, class Offset>
Vec<D> GatherOffset(D, const TFromD<D>* base, Vec1<Offset> offset) {
    Vec<D> v;
    std::memcpy(&v.raw, reinterpret_cast<const char*>(base) + offset.raw, sizeof v.raw);
    return v;
}

template <class T>
T GetLane(Vec1<T> v) {
    return v.raw;
}

template <class D>
Vec<D> MinOfLanes(D, Vec<D> v) {
    return v;
}

template <class D>
Vec<D> MaxOfLanes(D, Vec<D> v) {
    return v;
}

// Arithmetic. Whole numbers wrap around, as those of processors do.

template <class T, class Operation>
Vec1<T> wrapped(Vec1<T> a, Vec1<T> b, const Operation& operation) {
    if constexpr (std::is_integral_v<T>) {
        using U = std::make_unsigned_t<T>;
        // 16 bits would become an int, which may overflow.
        using Wide = std::conditional_t<(sizeof(U) < sizeof(unsigned)), unsigned, U>;
        return {static_cast<T>(static_cast<U>(
            operation(static_cast<Wide>(static_cast<U>(a.raw)), static_cast<Wide>(static_cast<U>(b.raw)))))};
    } else {
        return {operation(a.raw, b.raw)};
    }
}

template <class T>
Vec1<T> Add(Vec1<T> a, Vec1<T> b) {
    return wrapped(a, b, [](auto x, auto y) { return x + y; });
}

template <class T>
Vec1<T> Sub(Vec1<T> a, Vec1<T> b) {
    return wrapped(a, b, [](auto x, auto y) { return x - y; });
}

template <class T>
Vec1<T> Mul(Vec1<T> a, Vec1<T> b) {
    return wrapped(a, b, [](auto x, auto y) { return x * y; });
}

template <class T>
Vec1<T> Div(Vec1<T> a, Vec1<T> b) {
    return {a.raw / b.raw};
}

template <class T>
Vec1<T> operator+(Vec1<T> a, Vec1<T> b) {
    return Add(a, b);
}

template <class T>
Vec1<T> operator-(Vec1<T> a, Vec1<T> b) {
    return Sub(a, b);
}

template <class T>
Vec1<T> operator*(Vec1<T> a, Vec1<T> b) {
    return Mul(a, b);
}

template <class T>
Vec1<T> operator/(Vec1<T> a, Vec1<T> b) {
    return Div(a, b);
}

/// The upper half of the product.
template <class T>
Vec1<T> MulHigh(Vec1<T> a, Vec1<T> b) {
    static_assert(sizeof(T) == 2);
    return {static_cast<T>((std::int64_t{a.raw} * b.raw) >> 16)};
}

template <class T>
Vec1<T> Sqrt(Vec1<T> v) {
    return {std::sqrt(v.raw)};
}

template <class T>
Vec1<T> Abs(Vec1<T> v) {
    return {static_cast<T>(std::abs(v.raw))};
}

template <class T>
Vec1<T> Neg(Vec1<T> v) {
    return {static_cast<T>(-v.raw)};
}

/// As processors do: b where one is not a number.
template <class T>
Vec1<T> Min(Vec1<T> a, Vec1<T> b) {
    return {a.raw < b.raw ? a.raw : b.raw};
}

template <class T>
Vec1<T> Max(Vec1<T> a, Vec1<T> b) {
    return {a.raw > b.raw ? a.raw : b.raw};
}

template <class T>
Vec1<T> CopySignToAbs(Vec1<T> magnitude, Vec1<T> sign) {
    return {std::copysign(magnitude.raw, sign.raw)};
}

// Bits.

template <class T>
Vec1<T> And(Vec1<T> a, Vec1<T> b) {
    return {static_cast<T>(a.raw & b.raw)};
}

template <class T>
Vec1<T> Or(Vec1<T> a, Vec1<T> b) {
    return {static_cast<T>(a.raw | b.raw)};
}

template <class T>
Vec1<T> Xor(Vec1<T> a, Vec1<T> b) {
    return {static_cast<T>(a.raw ^ b.raw)};
}

template <int kBits, class T>
Vec1<T> ShiftLeft(Vec1<T> v) {
    return {static_cast<T>(static_cast<std::make_unsigned_t<T>>(v.raw) << kBits)};
}

template <int kBits, class T>
Vec1<T> ShiftRight(Vec1<T> v) {
    return {static_cast<T>(v.raw >> kBits)};
}

template <class D, class T>
Vec<D> BitCast(D, Vec1<T> v) {
    Vec<D> result;
    static_assert(sizeof result == sizeof v);
    std::memcpy(&result, &v, sizeof v);
    return result;
}

// Comparisons and masks.

template <class T>
Mask1<T> Eq(Vec1<T> a, Vec1<T> b) {
    return {a.raw == b.raw};
}

template <class T>
Mask1<T> Lt(Vec1<T> a, Vec1<T> b) {
    return {a.raw < b.raw};
}

template <class T>
Mask1<T> Le(Vec1<T> a, Vec1<T> b) {
    return {a.raw <= b.raw};
}

template <class T>
Mask1<T> Gt(Vec1<T> a, Vec1<T> b) {
    return {a.raw > b.raw};
}

template <class T>
Mask1<T> Ge(Vec1<T> a, Vec1<T> b) {
    return {a.raw >= b.raw};
}

template <class T>
Mask1<T> And(Mask1<T> a, Mask1<T> b) {
    return {a.raw && b.raw};
}

template <class T>
Mask1<T> AndNot(Mask1<T> a, Mask1<T> b) {
    return {!a.raw && b.raw};
}

template <class T>
Mask1<T> Or(Mask1<T> a, Mask1<T> b) {
    return {a.raw || b.raw};
}

template <class T>
Mask1<T> Not(Mask1<T> m) {
    return {!m.raw};
}

template <class D, class T>
Mask<D> RebindMask(D, Mask1<T> m) {
    return {m.raw};
}

template <class D>
bool AllTrue(D, Mask<D> m) {
    return m.raw;
}

template <class D>
bool AllFalse(D, Mask<D> m) {
    return !m.raw;
}

template <class D>
std::size_t CountTrue(D, Mask<D> m) {
    return m.raw ? 1 : 0;
}

template <class T>
Vec1<T> IfThenElse(Mask1<T> m, Vec1<T> yes, Vec1<T> no) {
    return m.raw ? yes : no;
}

template <class T>
Vec1<T> IfThenElseZero(Mask1<T> m, Vec1<T> yes) {
    return m.raw ? yes : Vec1<T>{T(0)};
}

// Conversions. What does not fit becomes the nearest value that fits; fractions are cut off.

template <class To, class From>
To fitted(From value) {
    if constexpr (std::is_floating_point_v<To>) {
        return static_cast<To>(value);
    } else {
        constexpr auto kLeast = std::numeric_limits<To>::lowest();
        constexpr auto kMost = std::numeric_limits<To>::max();
        // Of floating point, the greatest value that fits may be rounded up to one that does not.
        return value >= static_cast<From>(kMost)    ? kMost
               : value <= static_cast<From>(kLeast) ? kLeast
               : value == value                     ? static_cast<To>(value)
                                                    : To(0);
    }
}

template <class D, class T>
Vec<D> ConvertTo(D, Vec1<T> v) {
    return {fitted<TFromD<D>>(v.raw)};
}

template <class D, class T>
Vec<D> DemoteTo(D, Vec1<T> v) {
    return {fitted<TFromD<D>>(v.raw)};
}

template <class D, class T>
Vec<D> PromoteTo(D, Vec1<T> v) {
    return {static_cast<TFromD<D>>(v.raw)};
}

inline Vec1<std::int32_t> NearestInt(Vec1<float> v) {
    return {fitted<std::int32_t>(std::nearbyint(v.raw))};
}

} // namespace hwy::N_SCALAR
