#include "Variants.h"

namespace insonate::phantom {
namespace {

VariantModel variant(PhantomVariant about, void (*change)(NeckParameters&)) {
  VariantModel model{about, {}};
  change(model.parameters);
  return model;
}

}  // namespace

std::span<const VariantModel> variantModels() {
  static const VariantModel kVariants[] = {
      variant({"textbook", "Textbook neck", "easy",
               "A wide right internal jugular vein lateral to the carotid, about 13 mm below the skin."},
              [](NeckParameters&) {}),
      variant({"large-sternomastoid", "Muscular neck", "easy",
               "A thick sternocleidomastoid and a wide vein; the vein lies deeper than usual."},
              [](NeckParameters& n) {
                n.sternomastoidScale = 1.3;
                n.veinWidth[0] = 1.08;
                n.fat_mm = 3;
              }),
      variant({"high-bifurcation", "High carotid bifurcation", "moderate",
               "The common carotid divides above the hyoid; one round artery all the way up."},
              [](NeckParameters& n) {
                n.bifurcation_z_mm = 43;
                n.veinMedial_mm[0] = 2.6;
              }),
      variant({"low-bifurcation", "Low carotid bifurcation", "moderate",
               "The carotid artery divides below the cricoid, so two arteries lie beside the vein."},
              [](NeckParameters& n) { n.bifurcation_z_mm = -8; }),
      variant({"small-vein", "Small jugular vein", "moderate",
               "The right jugular vein has less than half of its usual area. The left one is larger."},
              [](NeckParameters& n) {
                n.veinWidth[0] = 0.68;
                n.veinHeight[0] = 0.68;
                n.veinWidth[1] = 0.95;
                n.veinHeight[1] = 0.95;
              }),
      variant({"head-turned", "Head turned to the left", "moderate",
               "The head is turned 40 degrees to the left. The muscle and the right vein lie over the carotid artery."},
              [](NeckParameters& n) {
                n.headTurn_deg = 40;
                n.veinMedial_mm[0] = 2.3;  // over half of the carotid: see PhantomTest
                n.veinForward_mm[0] = 0.8;
                n.carotidLateral_mm = 1.5;
              }),
      variant({"deep-in-fat", "Vein deep in fat", "hard",
               "Thick subcutaneous fat: the vein begins more than 20 mm below the skin."},
              [](NeckParameters& n) {
                n.fat_mm = 13;
                n.veinWidth[0] = 0.92;
              }),
      variant({"collapsed-vein", "Empty, flat vein", "hard",
               "Low filling: both jugular veins are flat slits, wide but only 4 mm high."},
              [](NeckParameters& n) {
                for (int s : {0, 1}) {
                  n.veinWidth[s] = 1.0;
                  n.veinHeight[s] = 0.4;
                }
              }),
      variant({"vein-over-artery", "Vein in front of the carotid", "hard",
               "Both jugular veins lie in front of the carotid artery. A needle that passes through the vein reaches "
               "the artery."},
              [](NeckParameters& n) {
                for (int s : {0, 1}) {
                  n.veinMedial_mm[s] = 4.2;
                  n.veinForward_mm[s] = 0.9;
                  n.veinHeight[s] = 0.86;
                }
                n.carotidLateral_mm = 3.2;
              }),
      variant({"subclavian", "Below the right clavicle", "moderate",
               "The right axillary and subclavian vein, 12 mm wide and 20 mm below the skin, in front of the artery; "
               "behind them first and second rib, pleura and lung."},
              [](NeckParameters& n) {
                n.chest = true;
                n.fat_mm = 3.2;
              })};
  return kVariants;
}

}  // namespace insonate::phantom
