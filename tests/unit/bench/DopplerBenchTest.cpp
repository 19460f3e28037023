#include "support/TestData.h"

#include <insonate/bench/DopplerBench.h>
#include <insonate/ultrasound/ColorDoppler.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace insonate {
namespace {

TEST(DopplerBench, MeasuresWithinItsLimitsAndWritesItsFiles) {
  const auto bench = runDopplerBench(true);
  ASSERT_TRUE(bench) << bench.error().message;
  int limited = 0;
  for (const DopplerBenchRow& row : bench->rows) {
    if (row.limit_percent <= 0) continue;
    EXPECT_LT(row.error_percent, row.limit_percent) << row.engine << ' ' << row.measure << ' ' << row.condition;
    ++limited;
  }
  const int engines = makeColorDoppler("glsl") ? 3 : 2;
  EXPECT_EQ(limited, 8 * engines + 6);
  // Color grows with the gain: it fills less than the lumen, then more.
  double before = 0;
  for (const DopplerBenchRow& row : bench->rows)
    if (row.engine == "cpu" && row.measure == "area of color") {
      EXPECT_GE(row.measured, before) << row.condition;
      before = row.measured;
    }
  EXPECT_GT(before, 0);
  EXPECT_EQ(bench->costs.size(), engines == 3 ? 3 : 2);
  EXPECT_GT(bench->spectral.perSecond_ms, 0);
  const test::TemporaryFolder folder;
  const std::filesystem::path out = folder / "doppler";
  ASSERT_TRUE(writeDopplerBench(*bench, out));
  for (const char* file : {"doppler.json", "doppler.csv", "cost.csv", "spectral.csv", "doppler.md"})
    EXPECT_TRUE(std::filesystem::exists(out / file)) << file;
  EXPECT_EQ(toJson(*bench)["rows"].size(), bench->rows.size());
}

}  // namespace
}  // namespace insonate
