#include "files/LabelNames.h"

#include <insonate/cases/VesselName.h>

#include <gtest/gtest.h>

namespace insonate {
namespace {

struct Named {
  const char* name;
  KnownVessel vessel;
  BodySide side;
  Label label;
};

class VesselLocator : public testing::TestWithParam<Named> {};

TEST_P(VesselLocator, AreReadInFiveLanguages) {
  const Named& expected = GetParam();
  const VesselName parsed = parsedVesselName(expected.name);
  EXPECT_EQ(parsed.vessel, expected.vessel) << expected.name;
  EXPECT_EQ(parsed.side, expected.side) << expected.name;
  EXPECT_EQ(parsed.label, expected.label) << expected.name;
  EXPECT_EQ(labelFromAnyName(expected.name), expected.label) << expected.name;
}

constexpr auto kRight = BodySide::Right, kLeft = BodySide::Left;
constexpr auto kInternalJugular = KnownVessel::InternalJugular, kCommonCarotid = KnownVessel::CommonCarotid;

const Named kNames[] = {
    {"right internal jugular vein", kInternalJugular, kRight, kVein},
    {"Internal_jugular_vein_left", kInternalJugular, kLeft, kVein},
    {"V. jugularis interna rechts", kInternalJugular, kRight, kVein},
    {"linke innere Jugularvene", kInternalJugular, kLeft, kVein},
    {"Vena jugularis interna dextra", kInternalJugular, kRight, kVein},
    {"VENA JUGULARIS INTERNA SINISTRA", kInternalJugular, kLeft, kVein},
    {"veine jugulaire interne droite", kInternalJugular, kRight, kVein},
    {"Veine jugulaire interne gauche", kInternalJugular, kLeft, kVein},
    {"vena yugular interna derecha", kInternalJugular, kRight, kVein},
    {"vena yugular interna izquierda", kInternalJugular, kLeft, kVein},
    {"\u00c4u\u00dfere Drosselvene links, Vene", KnownVessel::ExternalJugular, kLeft, kVein},
    {"v. jugularis externa dextra", KnownVessel::ExternalJugular, kRight, kVein},
    {"A. carotis communis re.", kCommonCarotid, kRight, kArtery},
    {"Arteria carotis communis sinistra", kCommonCarotid, kLeft, kArtery},
    {"art\u00e8re carotide commune droite", kCommonCarotid, kRight, kArtery},
    {"arte\u0300re carotide commune droite", kCommonCarotid, kRight, kArtery},
    {"arteria car\u00f3tida com\u00fan izquierda", kCommonCarotid, kLeft, kArtery},
    {"Arteria carotis externa dextra", KnownVessel::ExternalCarotid, kRight, kArtery},
    {"car\u00f3tida interna derecha", KnownVessel::InternalCarotid, kRight, kArtery},
    {"veine sous-clavi\u00e8re gauche", KnownVessel::Subclavian, kLeft, kVein},
    {"vena subclavia dextra", KnownVessel::Subclavian, kRight, kVein},
    {"vena braquiocef\u00e1lica izquierda", KnownVessel::Brachiocephalic, kLeft, kVein},
    {"A. vertebralis sinistra", KnownVessel::Vertebral, kLeft, kArtery},
    {"right common femoral vein", KnownVessel::Femoral, kRight, kVein},
    {"V. femoralis dextra", KnownVessel::Femoral, kRight, kVein},
    {"art\u00e8re f\u00e9morale gauche", KnownVessel::Femoral, kLeft, kArtery},
    {"linke Oberschenkelvene, Vene", KnownVessel::Femoral, kLeft, kVein},
    {"A. profunda femoris dextra", KnownVessel::Femoral, kRight, kArtery},
    {"right external iliac artery", KnownVessel::Iliac, kRight, kArtery},
    {"vena safena magna derecha", KnownVessel::Saphenous, kRight, kVein},
    {"right basilic vein", KnownVessel::Basilic, kRight, kVein},
    {"V. basilica sinistra", KnownVessel::Basilic, kLeft, kVein},
    {"A. brachialis dextra", KnownVessel::Brachial, kRight, kArtery},
    {"veine c\u00e9phalique droite", KnownVessel::Cephalic, kRight, kVein},
};
INSTANTIATE_TEST_SUITE_P(Each, VesselLocator, testing::ValuesIn(kNames));

TEST(VesselNameParts, ThatAreNotStatedAreEmpty) {
  EXPECT_FALSE(parsedVesselName("leftover vein").side);
  EXPECT_FALSE(parsedVesselName("vein left of the right lobe").side);
  EXPECT_FALSE(parsedVesselName("Vene").vessel);
  EXPECT_EQ(parsedVesselName("jugular vein").vessel, KnownVessel::Jugular) << "internal or external";
  EXPECT_FALSE(parsedVesselName("").label);
}

TEST(VesselNameParts, WhatLiesBesideVesselsIsNoVessel) {
  EXPECT_EQ(labelFromAnyName("left jugular lymph node"), kLymphNode);
  EXPECT_EQ(labelFromAnyName("Nervus vertebralis"), kNerve);
  EXPECT_EQ(labelFromAnyName("seventh cervical vertebra"), kBone);
  EXPECT_FALSE(labelFromAnyName("Musculus subclavius"));
}

TEST(NamesVessel, TheSameVesselInAnotherLanguage) {
  EXPECT_TRUE(namesVessel("right internal jugular vein", "internal jugular"));
  EXPECT_TRUE(namesVessel("Vena jugularis interna dextra", "internal jugular"));
  EXPECT_TRUE(namesVessel("veine sous-clavi\u00e8re gauche", "subclavian"));
  EXPECT_FALSE(namesVessel("Vena jugularis externa dextra", "internal jugular"));
  EXPECT_FALSE(namesVessel("Arteria subclavia", "subclavian vein"));
  EXPECT_FALSE(namesVessel("vein", "internal jugular"));
}

}  // namespace
}  // namespace insonate
