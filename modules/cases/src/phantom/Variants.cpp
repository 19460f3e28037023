#include "Variants.h"

namespace insonate::phantom {
namespace {

template <class Parameters>
VariantModel variant(PhantomVariant about, void (*change)(Parameters&)) {
  Parameters parameters;
  change(parameters);
  return {about, parameters};
}

}  // namespace

std::span<const VariantModel> variantModels() {
  static const VariantModel kVariants[] = {
      variant<NeckParameters>(
          {PhantomRegion::kNeck, "textbook", "Textbook neck", "easy",
           "A wide right internal jugular vein lateral to the carotid, about 13 mm below the skin."},
          [](NeckParameters&) {}),
      variant<NeckParameters>({PhantomRegion::kNeck, "large-sternomastoid", "Muscular neck", "easy",
                               "A thick sternocleidomastoid and a wide vein; the vein lies deeper than usual."},
                              [](NeckParameters& n) {
                                n.sternomastoidScale = 1.3;
                                n.veinWidth[0] = 1.08;
                                n.fat_mm = 3;
                              }),
      variant<NeckParameters>({PhantomRegion::kNeck, "high-bifurcation", "High carotid bifurcation", "moderate",
                               "The common carotid divides above the hyoid; one round artery all the way up."},
                              [](NeckParameters& n) {
                                n.bifurcation_z_mm = 43;
                                n.veinMedial_mm[0] = 2.6;
                              }),
      variant<NeckParameters>({PhantomRegion::kNeck, "low-bifurcation", "Low carotid bifurcation", "moderate",
                               "The carotid artery divides below the cricoid, so two arteries lie beside the vein."},
                              [](NeckParameters& n) { n.bifurcation_z_mm = -8; }),
      variant<NeckParameters>({PhantomRegion::kNeck, "small-vein", "Small jugular vein", "moderate",
                               "The right jugular vein has less than half of its usual area. The left one is larger."},
                              [](NeckParameters& n) {
                                n.veinWidth[0] = 0.68;
                                n.veinHeight[0] = 0.68;
                                n.veinWidth[1] = 0.95;
                                n.veinHeight[1] = 0.95;
                              }),
      variant<NeckParameters>(
          {PhantomRegion::kNeck, "head-turned", "Head turned to the left", "moderate",
           "The head is turned 40 degrees to the left. The muscle and the right vein lie over the carotid artery."},
          [](NeckParameters& n) {
            n.headTurn_deg = 40;
            n.veinMedial_mm[0] = 2.3;  // over half of the carotid: see PhantomTest
            n.veinForward_mm[0] = 0.8;
            n.carotidLateral_mm = 1.5;
          }),
      variant<NeckParameters>({PhantomRegion::kNeck, "deep-in-fat", "Vein deep in fat", "hard",
                               "Thick subcutaneous fat: the vein begins more than 20 mm below the skin."},
                              [](NeckParameters& n) {
                                n.fat_mm = 13;
                                n.veinWidth[0] = 0.92;
                              }),
      variant<NeckParameters>({PhantomRegion::kNeck, "collapsed-vein", "Empty, flat vein", "hard",
                               "Low filling: both jugular veins are flat slits, wide but only 4 mm high."},
                              [](NeckParameters& n) {
                                for (int s : {0, 1}) {
                                  n.veinWidth[s] = 1.0;
                                  n.veinHeight[s] = 0.4;
                                }
                              }),
      variant<NeckParameters>(
          {PhantomRegion::kNeck, "vein-over-artery", "Vein in front of the carotid", "hard",
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
      variant<NeckParameters>(
          {PhantomRegion::kChest, "subclavian", "Below the right clavicle", "moderate",
           "The right axillary and subclavian vein, 12 mm wide and 20 mm below the skin, in front of the artery; "
           "behind them first and second rib, pleura and lung."},
          [](NeckParameters& n) {
            n.chest = true;
            n.fat_mm = 3.2;
          }),
      variant<NeckParameters>(
          {PhantomRegion::kChest, "axillary", "Below the outer right clavicle", "hard",
           "The right axillary vein lateral of the first rib, deeper than farther medial, and farther from the "
           "artery and from the pleura."},
          [](NeckParameters& n) {
            n.chest = true;
            n.axillary = true;
            n.fat_mm = 3.2;
          }),
      variant<ArmParameters>(
          {PhantomRegion::kArm, "arm", "Right upper arm", "easy",
           "The inner side of the right upper arm: the basilic vein, 4.6 mm wide and 8 mm below the skin, beside "
           "the brachial artery, its two veins, and the median and ulnar nerves."},
          [](ArmParameters&) {}),
      variant<GroinParameters>(
          {PhantomRegion::kGroin, "groin", "Right groin", "moderate",
           "The right femoral vein medial to the artery, 15 mm below the skin, and the great saphenous vein that "
           "joins it. Farther from the ligament, the artery lies in front of the vein."},
          [](GroinParameters&) {}),
      variant<GroinParameters>(
          {PhantomRegion::kGroin, "groin-thrombus", "Right groin with thrombus", "moderate",
           "A thrombus fills the right femoral vein below the saphenofemoral junction. There, the vein does not "
           "flatten under compression. Nearer to the ligament it is open."},
          [](GroinParameters& n) { n.hasThrombus = true; }),
      variant<GroinParameters>(
          {PhantomRegion::kGroin, "groin-overlap", "Right groin, artery over the vein", "hard",
           "The right femoral artery covers most of the vein just below the inguinal ligament, as it usually does "
           "farther down the thigh. A needle that comes from the front meets the artery first."},
          [](GroinParameters& n) { n.overlap = 1; }),
      variant<GroinParameters>(
          {PhantomRegion::kGroin, "groin-obese", "Right groin, obese", "hard",
           "Thick subcutaneous fat: the right femoral vein begins more than 25 mm below the skin."},
          [](GroinParameters& n) { n.fat_mm = 20; })};
  return kVariants;
}

}  // namespace insonate::phantom
