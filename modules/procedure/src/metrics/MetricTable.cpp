#include <insonate/procedure/MetricTitle.h>

#include <array>
#include <charconv>
#include <cmath>

namespace insonate {
namespace {

constexpr std::string_view kThesis =
    "one of the five metrics of Patient-specific Virtual Ultrasound Imagery for Virtual Reality Simulation of Central "
    "Line Placement";
constexpr std::string_view kTrainer = "used by haptic trainers (Pepley et al., J Surg Educ 2017, 74:1066)";
constexpr std::string_view kPerkTutor =
    "19 novices before and after practice: the path became shorter and straighter (Xia et al., Proc SPIE Medical "
    "Imaging 2018, doi "
    "10.1117/12.2293789)";
constexpr std::string_view kUnnamed = "used by other trainers; no study that shows its validity is known to us";

constexpr std::string_view kChecklist =
    "an item of published checklists of central line insertion (Barsuk et al., J Hosp Med 2009, 4:397)";
constexpr std::string_view kWireSeen =
    "ASA Practice Guidelines for Central Venous Access, Anesthesiology 2020, 132:8: confirm the vein before dilation; "
    "blood color and absence of pulsation are not sufficient";
constexpr std::string_view kWireLength =
    "Andrews et al., Crit Care Med 2000, 28:138: the cavo-atrial junction is on average 16 cm (right internal jugular "
    "vein) to 21 cm (left subclavian vein) from the puncture; 18 cm should be the upper limit for the wire";
constexpr std::string_view kLineSafety =
    "a complication that the ASA Practice Guidelines for Central Venous Access (Anesthesiology 2020, 132:8) name";
constexpr std::string_view kWireKink =
    "kinks and knots of guidewires that were pushed on against a resistance (Han et al., Korean J Anesthesiol 2011, "
    "60:362)";
constexpr std::string_view kSurvey =
    "RaCeVA, a scan of all veins of a region before the choice of the vein (Spencer and Pittiruti, J Vasc Access 2019, "
    "doi 10.1177/1129729818804718)";
constexpr std::string_view kColorCheck =
    "color Doppler confirms which vessel is the artery (Troianos et al., J Am Soc Echocardiogr 2011, 24:1291)";

using enum Metric;
using enum Better;

constexpr std::array<MetricDefinition, kMetricCount> kTable{{
    {VeinPunctures, "vein_punctures", 1, "", Neither,
     "Number of times the advancing needle punctured the target vein from outside. A further puncture counts "
     "only after the tip was withdrawn more than 1 mm out of the last hole.",
     kThesis},
    {ArteryPunctures, "artery_punctures", 1, "", Lower,
     "Number of times the advancing needle punctured an artery from outside. Repeated punctures are counted as "
     "for the vein.",
     "thesis; Auyong et al., Anesthesiology 2015, 123:535: 21 % without needle guidance, 2 % with it"},
    {PosteriorWallPunctures, "double_punctures", 1, "", Lower,
     "Number of times the needle punctured the posterior wall of the target vein from inside. A further "
     "puncture counts only after the tip was withdrawn more than 1 mm out of the last hole.",
     "thesis; Auyong et al., Anesthesiology 2015, 123:535: 49 % without needle guidance, 13 % with it"},
    {TimeToVein, "time_to_vein_s", 1, "s", Lower,
     "Time from the puncture of the skin to the first puncture of the vein, in the pass that first reached the "
     "vein.",
     kThesis},
    {UsedNeedleInsertions, "used_needle_insertions", 1, "", Lower,
     "Number of passes with a used needle. A needle counts as used after it was withdrawn more than 2 mm out "
     "of the skin, until it is replaced.",
     kThesis},
    {TimeToAccess, "time_to_access_s", 1, "s", Lower,
     "Time from the first puncture of the skin to access, which is the first puncture of the target vein. All "
     "passes in between are included.",
     "Clinkard et al., Acad Emerg Med 2015, 22:212: experts 50 s, residents 149 s; judged alone, it rewards haste"},
    {AttemptTime, "attempt_time_s", 1, "s", Lower, "Time from the start of the attempt to its end.", kUnnamed},
    {Passes, "passes", 1, "", Lower,
     "Number of times the needle punctured the skin. A further pass counts only after the tip was withdrawn "
     "more than 2 mm out of the last hole.",
     kTrainer},
    {Redirections, "redirections", 1, "", Lower,
     "Number of times the needle was withdrawn by 3 mm or more and then advanced by 3 mm or more, while its "
     "tip stayed under the skin. Redirections after access do not count.",
     "randomized crossover of 50 novices (PubMed 37548027): fewer with magnetic guidance, p = 0.01"},
    {LungPunctures, "lung_punctures", 1, "", Lower,
     "Number of times the advancing needle punctured lung or airway from outside. Repeated punctures are "
     "counted as for the vein.",
     kUnnamed},
    {BoneContacts, "bone_contacts", 1, "", Lower,
     "Number of times the tip touched bone. A further contact counts only after the tip moved more than 1 mm "
     "away from the place of the last contact.",
     kUnnamed},
    {NeedlePath, "needle_path_mm", 1, "mm", Lower,
     "Length of the path of the tip from the puncture of the skin until access, in all passes. Without access, "
     "the path ends with the attempt. Before the puncture, the tip pushes the skin ahead by some millimeters. "
     "The path of a pass is shorter than the insertion length by this distance. The path is measured in steps "
     "of at least 0.5 mm. Therefore, the value can be up to 1 mm too small at a sharp turn.",
     kPerkTutor},
    {NeedleInefficiency, "needle_inefficiency_percent", 1, "%", Lower,
     "Percentage by which the path of the needle was longer than necessary. It is 100 (L / D - 1). L is the "
     "needle path until access. D is the straight distance from the puncture of the skin to the puncture of "
     "the vein, in the pass that reached the vein.",
     kPerkTutor},
    {PathDeviation, "path_deviation_mm", 1, "mm", Lower,
     "Root mean square distance of the tip from a straight line. The line goes from the puncture of the skin "
     "to the puncture of the vein. Only the pass that reached the vein counts. The path is measured in steps "
     "of at least 0.5 mm.",
     kUnnamed},
    {InsertionAngle, "insertion_angle_deg", 2, "deg", Neither,
     "Angle between the needle and the skin at the moment when the needle punctured the skin. At 90° the "
     "needle is perpendicular to the skin. The pass that reached the vein counts. If no pass reached the "
     "vein, the last pass counts. The direction of the skin is averaged over about 15 mm, without the "
     "indentation by the probe.",
     "30 to 45 degrees are taught (Pepley et al., J Surg Educ 2017, 74:1066); 45 degrees in the thesis"},
    {TipInImage, "tip_in_picture_percent", 2, "%", Higher,
     "Percentage of time in which the live image showed the tip. The time in which the tip is under the skin "
     "counts, until access. Without access, the time until the end of the attempt counts. The time in which "
     "the needle is frozen does not count. The image shows the tip if the tip is in the field of view and at "
     "most one slice thickness from the image plane. The slice thickness is the full width at half maximum at "
     "the depth of the tip.",
     "Ball et al., Br J Anaesth, doi 10.1093/bja/aer329: 36 % of the time without a needle guide, 90 % with one"},
    {AspirationWhileAdvancing, "aspiration_while_advancing_percent", 1, "%", Higher,
     "Percentage of the forward path of the tip on which the syringe aspirated. The path until access counts. "
     "It is measured in steps of 0.5 mm.",
     kUnnamed},
    {VeinCenterDistance, "vein_centre_distance_mm", 2, "mm", Lower,
     "Distance from the tip to the center line of the vein. It is measured at the last place in the vein "
     "where the tip rested. The tip rests if it moves by at most 0.5 mm in half a second. If the tip never "
     "rested in the vein, the distance at the puncture of the vein counts.",
     kTrainer},
    {TipInVein, "tip_in_vein", 3, "", Higher,
     "1 if the attempt ended with the tip in the vein; otherwise 0. The value is also 1 if the needle was "
     "withdrawn after its position was confirmed. A position is confirmed if the syringe aspirated in the "
     "vein for 1 s while the tip moved by at most 1 mm. Afterwards, the needle must not have met another wall "
     "or bone.",
     "Auyong et al., Anesthesiology 2015, 123:535: 76 % without needle guidance, 97 % with it"},
    {NearestArtery, "nearest_artery_mm", 1, "mm", Higher,
     "Minimum distance between the tip and the wall of an artery, while the tip was under the skin. The value "
     "is negative if the tip was inside an artery.",
     kUnnamed},
    {NearestLung, "nearest_lung_mm", 1, "mm", Higher,
     "Minimum distance between the tip and lung or airway, while the tip was under the skin. The value is "
     "negative if the tip was inside lung or airway.",
     kUnnamed},
    {ProbePath, "probe_path_mm", 1, "mm", Lower,
     "Length of the path of the center of the probe's face, from the first puncture of the skin to access. The "
     "path is measured in steps of at least 1 mm.",
     "Weinstein et al., J Vasc Interv Radiol 2023, 34:1337: weak evidence, area under the curve 0.61"},
    {ProbeTranslations, "probe_translations", 1, "", Lower,
     "Number of fast movements of the probe. A movement is fast if its speed over 50 ms is more than 50 mm/s. "
     "Fast movements that are at most 0.2 s apart count as one.",
     "Weinstein et al., J Vasc Interv Radiol 2023, 34:1337: area under the curve 0.86"},
    {ProbeRotations, "probe_rotations", 1, "", Lower,
     "Number of fast rotations of the probe. A rotation is fast if its speed over 50 ms is more than 50 "
     "degrees/s. Fast rotations that are at most 0.2 s apart count as one.",
     "Weinstein et al., J Vasc Interv Radiol 2023, 34:1337: area under the curve 0.91"},
    {ProbeForceMean, "probe_force_mean_N", 1, "N", Lower,
     "Mean force of the probe on the skin, while the probe touched the skin.", kUnnamed},
    {ProbeForceMost, "probe_force_max_N", 1, "N", Lower, "Maximum force of the probe on the skin.", kUnnamed},
    {OtherVeinPunctures, "other_vein_punctures", 1, "", Lower,
     "Number of times the advancing needle punctured a vein that is not the target vein. Repeated punctures "
     "are counted as for the target vein. In a case without a target vein, every vein counts as the target, "
     "and the value is 0.",
     kUnnamed},
    {VeinChecks, "vein_checks", 1, "", Higher,
     "Number of times the probe compressed the target vein to less than 40 % of its thickness. The vein must "
     "lie in the middle of the live image, and counts again 10 mm farther along. Compressions after the first puncture "
     "of the skin do not count.",
     "compression distinguishes a vein from an artery before the puncture (Troianos et al., J Am Soc Echocardiogr "
     "2011, "
     "24:1291)"},
    {Preparations, "preparations", 1, "", Higher,
     "Number of preparations that were done before the first puncture of the skin, of four: indication and consent, "
     "time-out, sterile cover of the probe, local anesthetic.",
     kChecklist},
    {OpenHub, "open_hub_s", 1, "s", Lower,
     "Time in which the hub of the needle was open while its tip was in the target vein. The hub is open if no "
     "syringe, no finger and no wire closes it.",
     kLineSafety},
    {AirVolume, "air_ml", 1, "ml", Lower,
     "Volume of air that was sucked into the vein. Air enters through an open hub while the pressure in the vein is "
     "below the pressure of the room.",
     kLineSafety},
    {WirePlanes, "wire_planes", 1, "", Higher,
     "Number of planes, short axis and long axis, in which the live image showed the wire in the target vein before "
     "the first dilation. Without a dilation, all planes until the end of the attempt count.",
     kWireSeen},
    {VeinConfirmations, "vein_confirmations", 2, "", Higher,
     "Number of different proofs of the target vein before the first dilation: wire in short axis, wire in long axis, "
     "pressure measured at the hub, bubbles of a saline flush in the live image. The color of blood is no proof.",
     kWireSeen},
    {UnconfirmedDilations, "unconfirmed_dilations", 1, "", Lower,
     "Number of times the dilator entered a vessel before the live image had shown the wire in the target vein in "
     "short axis and in long axis.",
     kWireSeen},
    {ArteryDilations, "artery_dilations", 1, "", Lower, "Number of times the dilator entered an artery.", kLineSafety},
    {WireControlLosses, "wire_control_losses", 1, "", Lower,
     "Number of times an instrument moved over the wire while the hand did not hold the wire. A further loss counts "
     "only after the wire was held again.",
     kChecklist},
    {WiresLost, "wires_lost", 1, "", Lower, "Number of wires that went into the body with their whole length.",
     kLineSafety},
    {WireDepth, "wire_depth_max_mm", 1, "mm", Neither, "Maximum length of the wire below the puncture of the skin.",
     kWireLength},
    {Ectopy, "ectopy_s", 1, "s", Lower,
     "Time in which the tip of the wire was beyond the cavo-atrial junction, where the wire causes extra beats.",
     kWireLength},
    {DilatorPasses, "dilator_passes", 1, "", Lower, "Number of times the dilator was inserted into the skin.",
     kChecklist},
    {DilatorDepth, "dilator_depth_max_mm", 1, "mm", Lower,
     "Maximum length of the dilator below the puncture of the skin. The dilator only has to reach the vein.",
     kChecklist},
    {CatheterToHeart, "catheter_to_heart_mm", 1, "mm", Neither,
     "Distance along the vessels from the tip of the catheter to the cavo-atrial junction, at the end of the attempt. "
     "The value is negative if the tip is beyond the junction, in the right atrium.",
     kUnnamed},
    {TimeToWire, "time_to_wire_s", 1, "s", Lower,
     "Time from access to the moment when the tip of the wire entered the target vein.", kUnnamed},
    {TimeToCatheter, "time_to_catheter_s", 1, "s", Lower,
     "Time from the first puncture of the skin to the moment when the tip of the catheter entered the target vein.",
     kUnnamed},
    {LumensFlushed, "lumens_flushed", 1, "", Higher,
     "Number of lumens of the catheter that were flushed and clamped, at the end of the attempt.", kChecklist},
    {LumensFlushedFirst, "lumens_flushed_first", 1, "", Lower,
     "Number of lumens that were flushed before blood was aspirated from them, so that air could enter the vein.",
     kChecklist},
    {BloodColorTrusted, "blood_color_trusted", 1, "", Lower,
     "Number of times the color of the blood was taken as proof of the vein. With low saturation or low pressure, "
     "blood of an artery is dark and slow.",
     kWireSeen},
    {CatheterInVein, "catheter_in_vein", 1, "", Higher,
     "1 if the attempt ended with the catheter in the target vein and the wire removed; otherwise 0.", kChecklist},
    {WireKinks, "wire_kinks", 1, "", Lower,
     "Number of wires that got a kink, because they bent too sharply or were pushed on against a resistance by 10 mm.",
     kWireKink},
    {Tachycardias, "tachycardias", 1, "", Lower,
     "Number of times the tip of the wire went more than 40 mm beyond the cavo-atrial junction, through the right "
     "atrium, where the wire causes a run of tachycardia.",
     kWireLength},
    {VeinsSurveyed, "veins_surveyed", 1, "", Higher,
     "Number of different veins of the case that the probe compressed in the middle of the live image before the first "
     "puncture of the skin.",
     kSurvey},
    {VeinLengthChecked, "vein_length_checked_mm", 1, "mm", Higher,
     "Largest distance between two places at which the probe compressed the target vein before the first puncture of "
     "the skin. A vein that flattens everywhere has no thrombus.",
     kSurvey},
    {ColorChecks, "color_checks", 1, "", Higher,
     "Number of times color Doppler covered the target vein in the middle of the live image for a second before the "
     "first puncture of the skin.",
     kColorCheck},
    {Pneumothoraces, "pneumothoraces", 1, "", Lower,
     "Number of lungs that the needle punctured. From the puncture on, the lung of this side no longer slides, first "
     "near the trachea and then farther to the side.",
     kUnnamed},
}};

/// In the order of Metric.
constexpr std::array<std::string_view, kMetricCount> kTitles{
    "vein punctures",
    "artery punctures",
    "posterior wall punctures",
    "time to vein",
    "used needle insertions",
    "time to access",
    "attempt time",
    "needle passes",
    "redirections",
    "lung punctures",
    "bone contacts",
    "needle path",
    "needle inefficiency",
    "path deviation",
    "insertion angle",
    "tip in image",
    "aspiration while advancing",
    "distance to vein center",
    "tip in vein",
    "minimum distance to artery",
    "minimum distance to lung",
    "probe path",
    "probe translations",
    "probe rotations",
    "mean probe force",
    "maximum probe force",
    "other vein punctures",
    "vein compressions",
    "preparations",
    "open hub",
    "air in the vein",
    "planes with the wire",
    "proofs of the vein",
    "unconfirmed dilations",
    "artery dilations",
    "losses of wire control",
    "lost wires",
    "maximum wire depth",
    "wire in the heart",
    "dilator insertions",
    "maximum dilator depth",
    "catheter tip to heart",
    "time to wire",
    "time to catheter",
    "flushed lumens",
    "lumens flushed before aspiration",
    "trust in blood color",
    "catheter in vein",
    "wire kinks",
    "tachycardias",
    "veins surveyed",
    "length of vein checked",
    "color Doppler checks",
    "pneumothoraces",
};

}  // namespace

std::string_view metricTitle(Metric metric) {
  return kTitles[static_cast<std::size_t>(metric)];
}

std::string metricText(Metric metric, const std::optional<double>& value) {
  if (!value) return "n/a";
  const std::string_view unit = definitionOf(metric).unit;
  const bool isCount = unit.empty() && *value == std::round(*value);
  // Not printf, which writes a comma in some countries.
  std::array<char, 400> number{};
  const auto end = std::to_chars(number.data(), number.data() + number.size(), *value, std::chars_format::fixed,
                                 isCount        ? 0
                                 : unit.empty() ? 2
                                                : 1);
  return std::string(number.data(), end.ptr) + (unit.empty()    ? ""
                                                : unit == "deg" ? std::string("\u00b0")
                                                                : " " + std::string(unit));
}

std::span<const MetricDefinition, kMetricCount> metricTable() {
  return kTable;
}

}  // namespace insonate
