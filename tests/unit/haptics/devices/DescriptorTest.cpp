#include "Descriptor.h"

#include <insonate/haptics/DeviceTable.h>

#include <gtest/gtest.h>

using namespace insonate;
using namespace insonate::test;

namespace {

/// A described run of fields, one by one as tables have them; buttons are one field of all.
void expectSame(const std::vector<DescribedField>& described, const ReportLayout& layout) {
  std::size_t next = 0;
  int end = 0;
  for (const DescribedField& run : described) {
    const bool buttons = run.usagePage == 9;
    const int fields = buttons ? 1 : run.count, bits = buttons ? run.bits * run.count : run.bits;
    for (int i = 0; i < fields; ++i, ++next) {
      ASSERT_LT(next, layout.fields.size());
      const ReportField& field = layout.fields[next];
      EXPECT_EQ(field.bit, run.bit + i * bits) << next;
      EXPECT_EQ(field.bits, bits) << next;
      EXPECT_EQ(field.isSigned, run.isSigned) << next;
      EXPECT_EQ(field.quantity == Quantity::kButtons, buttons) << next;
    }
    end = run.bit + run.bits * run.count;
  }
  EXPECT_EQ(next, layout.fields.size());
  EXPECT_EQ(end, layout.bytes * 8);
}

TEST(InsonateDescriptor, SaysWhatTheTableSays) {
  const auto bytes = insonateDescriptor();
  ASSERT_FALSE(bytes.empty());
  const DescribedReports described = parseDescriptor(bytes);
  EXPECT_TRUE(described.whole);
  EXPECT_EQ(described.openCollections, 0);
  const DeviceTable& table = builtInDeviceTables().at(0);
  ASSERT_TRUE(table.output && table.matches.size() == 1);
  EXPECT_EQ(described.usagePage, table.matches[0].usagePage);
  EXPECT_EQ(described.usage, table.matches[0].usage);
  ASSERT_EQ(described.input.size(), table.input.size());
  expectSame(described.input.at(table.input[0].id), table.input[0]);
  ASSERT_EQ(described.output.size(), 1U);
  expectSame(described.output.at(table.output->id), *table.output);
}

TEST(InsonateDescriptor, ReportsFitAFullSpeedPacket) {
  const DeviceTable& table = builtInDeviceTables().at(0);
  EXPECT_LE(table.input[0].bytes + 1, 64);
  EXPECT_LE(table.output->bytes + 1, 64);
}

}  // namespace
