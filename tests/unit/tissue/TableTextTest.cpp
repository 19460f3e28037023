#include <insonate/tissue/TableText.h>

#include <gtest/gtest.h>

namespace insonate {
namespace {

TEST(TableText, PresetsAreReadBackToTheLastBit) {
  for (const std::string& name : acousticPresetNames()) {
    AcousticTable table = *loadAcousticTable(name);
    table.tissues[kFat].impedance_MRayl = 4.0 / 3;
    const auto read = parseAcousticTable(textOf(table));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->tissues, table.tissues) << name;
    EXPECT_EQ(read->name, table.name);
  }
  for (const std::string& name : mechanicalPresetNames()) {
    const MechanicalTable table = *loadMechanicalTable(name);
    const auto read = parseMechanicalTable(textOf(table));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->tissues, table.tissues) << name << "; Table I has an infinite modulus";
    EXPECT_EQ(read->name, table.name);
  }
}

}  // namespace
}  // namespace insonate
