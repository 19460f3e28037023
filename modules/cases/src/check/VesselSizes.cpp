#include "VesselSizes.h"

#include <algorithm>
#include <iterator>

namespace insonate::check {
namespace {

/// If a source states mean and standard deviation, the range ends three standard deviations from the mean: the check
/// measures each vessel at many places, and shall not warn of one case in twenty. Impossible sizes are our choice:
/// twice the largest usual size, since an artery of 1.5 times its usual size is an aneurysm; for large veins, the limit
/// of the internal jugular vein. No size is impossibly small, since veins collapse and arteries may be narrow.
constexpr VesselSizes kVesselSizes[] = {
    // Area with the head down 166 +- 67 mm2: two and five standard deviations above the mean (300 and 500 mm2). In CT,
    // 181 +- 111 mm2 on the right and 120 +- 81 mm2 on the left (Crit Care 2009;13:R197, 190 adults). The smallest size
    // is our choice.
    {KnownVessel::InternalJugular, kVein, 4, 19.5, 25.2, "Anaesth Intensive Care 2008;36:65"},
    // No study of its size was found; dilated, it admits dialysis catheters of 4.8 mm (J Korean Soc Radiol
    // 2010;63:351).
    {KnownVessel::ExternalJugular, kVein, 1.5, 10, 20, "our choice"},
    // 124 +- 46 mm2 in 50 volunteers; the smallest size is our choice, since the vein collapses in inspiration.
    {KnownVessel::Subclavian, kVein, 4, 18.3, 25.2, "Roger et al., Anaesth Crit Care Pain Med 2017;36:65"},
    // 12 +- 3 mm on the right in 150 patients.
    {KnownVessel::Axillary, kVein, 3, 21, 25.2, "Can J Anaesth 2018, PMID 29209928"},
    // No study of its size was found. It is the union of internal jugular and subclavian vein, and no wider than the
    // superior vena cava.
    {KnownVessel::Brachiocephalic, kVein, 5, 22, 28, "our choice"},
    // Arm of 50 patients: basilic 4.2 +- 1.4 mm (1.2 to 7.8 mm), cephalic 3.1 +- 1.1 mm (0.6 to 6.3 mm).
    {KnownVessel::Basilic, kVein, 1.2, 8.4, 16.8, "our choice, after a mapping of 100 arms"},
    {KnownVessel::Cephalic, kVein, 0.6, 6.4, 12.8, "our choice, after a mapping of 100 arms"},
    // Sharp et al. measured it in 176 persons, mostly smaller than the basilic vein, whose limit it has here.
    {KnownVessel::Brachial, kVein, 1, 8.4, 16.8, "our choice, after Sharp et al., J Infus Nurs 2015;38:351"},
    // Area 20 mm below the ligament 114 +- 35 mm2 in 205 volunteers, and for a quarter of them below 45 mm2. The
    // smallest size, which includes the deep vein, is our choice.
    {KnownVessel::Femoral, kVein, 2, 16.7, 25.2, "Czyzewska et al., PLoS One 2017;12:e0182623"},
    // 3.7 +- 0.9 mm at the thigh to 7.5 +- 1.8 mm at the junction; with reflux, 10.9 +- 3.9 mm at the junction, which
    // gives the impossible size.
    {KnownVessel::Saphenous, kVein, 1, 12.9, 22.6, "Mendoza et al., Eur J Vasc Endovasc Surg 2013;45:76"},
    // Women 6.10 +- 0.80 mm, men 6.52 +- 0.98 mm; 500 patients.
    {KnownVessel::CommonCarotid, kArtery, 3.7, 9.5, 19, "Krejza et al., Stroke 2006;37:1103"},
    // Women 4.66 +- 0.78 mm (Krejza et al., Stroke 2006;37:1103); at the carotid sinus 7.59 +- 1.00 mm.
    {KnownVessel::InternalCarotid, kArtery, 2.3, 10.6, 21.2, "Baz et al., Medicina 2021;57:832"},
    // Smallest diameter 8.7 mm at the arch, 7.4 mm at the vertebral artery (Hirji et al., SCAI 2019); no spread stated.
    {KnownVessel::Subclavian, kArtery, 4, 14, 25, "our choice, after Hirji et al., SCAI 2019"},
    // 6.0 +- 1.1 mm in CT of 208 patients.
    {KnownVessel::Axillary, kArtery, 2.7, 9.3, 18.6, "Catheter Cardiovasc Interv 2018;91:150"},
    // 4.43 +- 0.87 mm in 4040 examinations. The smallest size, which includes the deep artery, is our choice.
    {KnownVessel::Brachial, kArtery, 1, 7.1, 14.2, "Herrington et al., J Cardiovasc Risk 2001;8:319"},
    // The common femoral artery has 6.9 +- 1.4 mm (Catheter Cardiovasc Interv 2001;53:289). The range is wider, since
    // the artery of old men is wider, and since the name includes the deep artery.
    {KnownVessel::Femoral, kArtery, 2, 13, 26, "our choice, after Catheter Cardiovasc Interv 2001;53:289"},
};

/// Limits for names without a range: those of the internal jugular vein, which is the largest vein near the skin. The
/// brachiocephalic trunk is up to 14 mm wide; the aorta is not measured.
constexpr VesselSizes kAnyVein{KnownVessel::Jugular, kVein, 0, 19.5, 25.2, "Anaesth Intensive Care 2008;36:65"};
constexpr VesselSizes kAnyArtery{KnownVessel::Carotid, kArtery, 0, 14, 22.6, "our choice"};

}  // namespace

std::span<const VesselSizes> vesselSizes() {
  return kVesselSizes;
}

const VesselSizes& sizesOf(std::string_view name, std::uint8_t label) {
  const auto vessel = parsedVesselName(name).vessel;
  const auto found = std::ranges::find_if(
      kVesselSizes, [&](const VesselSizes& sizes) { return vessel == sizes.vessel && sizes.label == label; });
  if (found != std::end(kVesselSizes)) return *found;
  return label == kVein ? kAnyVein : kAnyArtery;
}

double impossibleWidth_mm(std::uint8_t label) {
  return label == kVein ? 30 : 25;
}

}  // namespace insonate::check
