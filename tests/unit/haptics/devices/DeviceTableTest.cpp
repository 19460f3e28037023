#include <insonate/haptics/DeviceTable.h>

#include <gmock/gmock.h>

#include <string>

using namespace insonate;
using testing::HasSubstr;

namespace {

/// A table that is right, with one text in it replaced.
std::string tableWith(const std::string& from = "", const std::string& to = "") {
  std::string text = R"({"version": 1, "name": "N", "kind": "force", "source": "S",
    "match": [{"vendor": "16c0", "product": "0486"}],
    "input": [{"report": 1, "bytes": 4, "fields": [{"quantity": "encoder", "index": 0, "bit": 0, "bits": 16}]}],
    "output": {"report": 2, "bytes": 6, "fields": [{"quantity": "force", "index": 2, "bit": 32, "bits": 16}]},
    "limits": {"sensed_axes": 3, "force_axes": 3, "workspace_mm": [1, 2, 3], "max_force_N": 4, "rate_Hz": 1000}})";
  if (!from.empty()) text.replace(text.find(from), from.size(), to);
  return text;
}

std::string refusal(const std::string& from, const std::string& to) {
  const auto table = parseDeviceTable(tableWith(from, to));
  return table ? "" : table.error().message;
}

TEST(DeviceTable, ReadsWhatItSays) {
  const auto table = parseDeviceTable(tableWith());
  ASSERT_TRUE(table) << table.error().message;
  EXPECT_EQ(table->name, "N");
  EXPECT_EQ(table->kind, DeviceKind::kForce);
  ASSERT_EQ(table->matches.size(), 1U);
  EXPECT_EQ(table->matches[0].vendor, 0x16c0);
  EXPECT_FALSE(table->matches[0].usagePage);
  EXPECT_EQ(table->input[0].id, 1);
  EXPECT_EQ(table->output->fields[0].index, 2);
  EXPECT_EQ(table->limits.maxForce_N, 4);
  EXPECT_EQ(table->limits.workspace_mm, (Vec3{1, 2, 3}));
}

TEST(DeviceTable, RefusesWithTheReason) {
  EXPECT_THAT(refusal("{\"version\"", "\"version\""), HasSubstr("The device table is not valid JSON"));
  EXPECT_THAT(refusal("\"kind\": \"force\"", "\"kind\": \"toy\""),
              HasSubstr("has the unknown kind 'toy'; it is one of force, motion, pedal."));
  EXPECT_THAT(refusal("\"source\": \"S\",", ""), HasSubstr("has no 'source'."));
  EXPECT_THAT(refusal("16c0", "16cx"), HasSubstr("match 1 needs four hexadecimal digits as 'vendor', not '16cx'."));
  EXPECT_THAT(refusal("encoder", "encodr"),
              HasSubstr("field 1 has the unknown quantity 'encodr'; did you mean 'encoder'?"));
  EXPECT_THAT(refusal("\"index\": 2", "\"index\": 3"),
              HasSubstr("field 1 needs a number from 0 to 2 as 'index', not 3."));
  EXPECT_THAT(refusal("\"bit\": 32", "\"bit\": 33"), HasSubstr("reaches beyond its report"));
  EXPECT_THAT(refusal("\"bits\": 16}]}],", "\"bits\": 33}]}],"),
              HasSubstr("needs a number from 1 to 32 as 'bits', not 33."));
  EXPECT_THAT(refusal("\"sensed_axes\": 3", "\"sensed_axes\": 4"), HasSubstr("0, 3 or 6"));
  EXPECT_THAT(refusal("rate_Hz", "rate_hz"), HasSubstr("has an unknown 'rate_hz'; did you mean 'rate_Hz'?"));
  EXPECT_THAT(refusal("\"report\": 1", "\"raport\": 2, \"report\": 1"), HasSubstr("did you mean 'report'"));
  EXPECT_THAT(refusal("\"max_force_N\": 4,", ""), HasSubstr("force device of 0 N"));
  EXPECT_THAT(refusal("\"quantity\": \"force\"", "\"quantity\": \"current\""), HasSubstr("no 'arm'"));
}

TEST(DeviceTable, EveryBuiltInTableIsUsable) {
  std::vector<std::string> names;
  for (const DeviceTable& table : builtInDeviceTables()) names.push_back(table.name);
  // A table that cannot be read is missing here.
  EXPECT_THAT(names, testing::ElementsAre("Insonate home-built device", "Polhem v1", "WoodenHaptics", "SpaceMouse",
                                          "VEC Infinity IN-USB-2", "X-keys XK-3 foot pedal", "Keyboard-class pedal"));
}

}  // namespace
