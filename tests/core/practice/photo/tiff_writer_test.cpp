// SPDX-License-Identifier: GPL-3.0-or-later
#include "photo/tiff_writer.h"

#include <gtest/gtest.h>

namespace spherewalk::practice {
namespace {

using Order = TiffWriter::Order;

class TiffInBothOrders : public testing::TestWithParam<Order> {
  protected:
    /// The number of so many bytes at that place, in the order of the file.
    std::uint32_t number(std::size_t at, int size) const {
        std::uint32_t value = 0;
        for (int i = 0; i < size; ++i) {
            const int shift = GetParam() == Order::Big ? size - 1 - i : i;
            value |= std::uint32_t{m_tiff.bytes().at(at + std::size_t(i))} << 8 * shift;
        }
        return value;
    }

    TiffWriter m_tiff{GetParam()};
};

TEST_P(TiffInBothOrders, BeginsWithItsOrder) {
    ASSERT_EQ(m_tiff.size(), m_tiff.bytes().size());
    EXPECT_EQ(m_tiff.bytes().at(0), GetParam() == Order::Big ? 'M' : 'I');
    EXPECT_EQ(m_tiff.bytes().at(1), m_tiff.bytes().at(0));
    EXPECT_EQ(number(2, 2), 42U);
}

TEST_P(TiffInBothOrders, AnEntryHoldsWhatFitsAndPointsToTheRest) {
    const auto place = m_tiff.directory({m_tiff.ascii(0x010f, "ab"), m_tiff.ascii(0x0110, "a longer text"),
                                         m_tiff.shorts(0x0112, {1}), m_tiff.longs(0x0201, {7, 8})});
    EXPECT_EQ(number(place.offset, 2), 4U);
    const std::uint32_t brief = place.entry(0x010f);
    EXPECT_EQ(number(brief, 2), 0x010fU);
    EXPECT_EQ(number(brief + 2, 2), 2U) << "ASCII";
    EXPECT_EQ(number(brief + 4, 4), 3U) << "with its zero";
    EXPECT_EQ(m_tiff.bytes().at(brief + 8), 'a');
    const std::uint32_t lengthy = place.entry(0x0110);
    const std::uint32_t at = number(lengthy + 8, 4);
    EXPECT_EQ(std::string(m_tiff.bytes().begin() + at, m_tiff.bytes().begin() + at + 13), "a longer text");
    EXPECT_EQ(m_tiff.bytes().at(at + 13), 0);
    EXPECT_EQ(number(place.entry(0x0112) + 8, 2), 1U) << "a short number stands at the left";
    const std::uint32_t longs = number(place.entry(0x0201) + 8, 4);
    EXPECT_EQ(number(longs, 4), 7U);
    EXPECT_EQ(number(longs + 4, 4), 8U);
}

TEST_P(TiffInBothOrders, FractionsKeepTheirSign) {
    const auto place =
        m_tiff.directory({m_tiff.rationals(0x829a, {{1, 60}}), m_tiff.signedRationals(0x9204, {{-7, 10}})});
    const std::uint32_t time = number(place.entry(0x829a) + 8, 4);
    EXPECT_EQ(number(time, 4), 1U);
    EXPECT_EQ(number(time + 4, 4), 60U);
    const std::uint32_t bias = number(place.entry(0x9204) + 8, 4);
    EXPECT_EQ(static_cast<std::int32_t>(number(bias, 4)), -7);
    EXPECT_EQ(number(place.entry(0x9204) + 2, 2), 10U) << "signed fractions are a type of their own";
}

TEST_P(TiffInBothOrders, ANumberIsWrittenOnceItIsKnown) {
    const auto first = m_tiff.directory({m_tiff.longs(0x8769, {0})});
    const std::uint32_t end = m_tiff.size();
    const auto second = m_tiff.directory({m_tiff.shorts(0x0112, {1})});
    EXPECT_GE(second.offset, end);
    m_tiff.patchLong(first.entry(0x8769) + 8, second.offset);
    m_tiff.patchLong(first.nextOffset, 0x01020304);
    EXPECT_EQ(number(first.entry(0x8769) + 8, 4), second.offset);
    EXPECT_EQ(number(first.nextOffset, 4), 0x01020304U);
    EXPECT_EQ(number(second.nextOffset, 4), 0U) << "the last directory";
    const std::uint32_t size = m_tiff.size();
    EXPECT_GE(m_tiff.append(Bytes{1, 2, 3}), size);
    EXPECT_EQ(m_tiff.bytes().back(), 3);
}

INSTANTIATE_TEST_SUITE_P(Tiff, TiffInBothOrders, testing::Values(Order::Big, Order::Little));

} // namespace
} // namespace spherewalk::practice
