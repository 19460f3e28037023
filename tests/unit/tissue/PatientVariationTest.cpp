#include <insonate/tissue/PatientVariation.h>

#include <gtest/gtest.h>

#include <cmath>

namespace insonate {
namespace {

AcousticTable neck() {
  return *loadAcousticTable("neck");
}

TEST(PatientVariation, TheSamePatientHasTheSameTissue) {
  EXPECT_EQ(tableOfPatient(neck(), 7).tissues, tableOfPatient(neck(), 7).tissues);
  EXPECT_NE(tableOfPatient(neck(), 7).tissues, tableOfPatient(neck(), 8).tissues);
}

TEST(PatientVariation, LeavesTransmissionAndBloodAsPublished) {
  const AcousticTable before = neck(), after = tableOfPatient(before, 3);
  for (int label = 0; label < kLabelCount; ++label) {
    const AcousticTissue &a = before.tissues[label], &b = after.tissues[label];
    EXPECT_EQ(a.impedance_MRayl, b.impedance_MRayl);
    EXPECT_EQ(a.attenuation_dBpcmMHz, b.attenuation_dBpcmMHz);
    EXPECT_EQ(a.attenuationExponent, b.attenuationExponent);
    EXPECT_EQ(a.texture, b.texture);
    EXPECT_EQ(a.layers.size(), b.layers.size());
    if (a.vessel || a.gas) {
      EXPECT_EQ(a.echogenicity_dB, b.echogenicity_dB);
    }
    if (a.roughness_dB == 0) {
      EXPECT_EQ(b.roughness_dB, 0);
    }
  }
}

/// Over many patients: the stated mean and spread, and layers that stay layers.
TEST(PatientVariation, SpreadsAboutTheTable) {
  const AcousticTable table = neck();
  const double muscle_dB = table.of(kMuscle).echogenicity_dB;
  double sum = 0, squares = 0;
  constexpr int kPatients = 2000;
  for (std::uint32_t patient = 0; patient < kPatients; ++patient) {
    const AcousticTable varied = tableOfPatient(table, patient);
    const double off_dB = varied.of(kMuscle).echogenicity_dB - muscle_dB;
    EXPECT_LE(std::abs(off_dB), 5);
    sum += off_dB, squares += off_dB * off_dB;
    for (const AcousticTissue& tissue : varied.tissues)
      for (const BoundaryLayer& layer : tissue.layers) {
        EXPECT_LT(layer.from_mm, layer.to_mm);
        EXPECT_GE(layer.patchiness, 0);
        EXPECT_LE(layer.patchiness, 1);
      }
  }
  EXPECT_NEAR(sum / kPatients, 0, 0.2);
  EXPECT_NEAR(std::sqrt(squares / kPatients), 2.5, 0.25);
}

}  // namespace
}  // namespace insonate
