#include <insonate/procedure/MetricTitle.h>

namespace insonate {
namespace {

constexpr std::string_view kThesis =
    "one of the five metrics of Patient-specific Virtual Ultrasound Imagery for Virtual Reality Simulation of Central "
    "Line Placement";
constexpr std::string_view kTrainer = "used by haptic trainers (Pepley et al., J Surg Educ 2017, 74:1066)";
constexpr std::string_view kPerkTutor =
    "19 novices before and after practice: shorter ways, less waste (Xia et al., Proc SPIE Medical Imaging 2018, doi "
    "10.1117/12.2293789)";
constexpr std::string_view kUnnamed =
    "used by trainers of the field; a study that shows its worth is not named here yet";

using enum Metric;
using enum Better;

constexpr std::array<MetricDefinition, kMetricCount> kTable{{
    {VeinPunctures, "vein_punctures", 1, "", Neither,
     "Punctures of the target vein from outside, along the needle. A tip that has not come back to 1 mm before the "
     "hole "
     "has not made another.",
     kThesis},
    {ArteryPunctures, "artery_punctures", 1, "", Lower,
     "Punctures of an artery from outside, along the needle, counted as those of the vein.",
     "thesis; Auyong et al., Anesthesiology 2015, 123:535: 21 % against 2 % with a guided needle"},
    {DoublePunctures, "double_punctures", 1, "", Lower,
     "Punctures of the vein's posterior wall, from inside. Counted again once the tip was 1 mm before the hole.",
     "thesis; Auyong et al., Anesthesiology 2015, 123:535: 49 % against 13 % with a guided needle"},
    {TimeToVein, "time_to_vein_s", 1, "s", Lower,
     "From the puncture of the skin to that of the vein, within the pass that reached the vein.", kThesis},
    {UsedNeedleInsertions, "used_needle_insertions", 1, "", Lower,
     "Passes with a needle that had been out of the skin by 2 mm and was not replaced.", kThesis},
    {TimeToAccess, "time_to_access_s", 1, "s", Lower,
     "From the first puncture of the skin to access, which is the first puncture of the vein, over all passes.",
     "Clinkard et al., Acad Emerg Med 2015, 22:212: experts 50 s, others 149 s; alone it can be gamed"},
    {AttemptTime, "attempt_time_s", 1, "s", Lower, "From the start of the attempt to its end.", kUnnamed},
    {Passes, "passes", 1, "", Lower,
     "Punctures of the skin. A tip that has not come out of the hole by 2 mm has not made another.", kTrainer},
    {Redirections, "redirections", 1, "", Lower,
     "Before access, under the skin: the needle is withdrawn by 3 mm, then advanced by 3 mm.",
     "randomised crossover of 50 novices (PubMed 37548027): fewer with magnetic guidance, p = 0.01"},
    {LungPunctures, "lung_punctures", 1, "", Lower, "Punctures of lung or airway, counted as those of the vein.",
     kUnnamed},
    {BoneContacts, "bone_contacts", 1, "", Lower, "Contacts of the tip with bone, 1 mm apart.", kUnnamed},
    {NeedlePath, "needle_path_mm", 1, "mm", Lower,
     "Path length of the tip under the skin over all passes until access, or the end; in steps of at least 0.5 mm, so "
     "that a turn may lose 1 mm.",
     kPerkTutor},
    {NeedleInefficiency, "needle_inefficiency_percent", 1, "%", Lower,
     "100 (L / D - 1): L is the needle path until access, D the distance from skin to vein in the pass that reached "
     "it.",
     kPerkTutor},
    {PathDeviation, "path_deviation_mm", 1, "mm", Lower,
     "Root mean square distance of the tip from the straight line from skin to vein, in the pass that reached it, in "
     "steps of at least 0.5 mm.",
     kUnnamed},
    {InsertionAngle, "insertion_angle_deg", 2, "deg", Neither,
     "Between the needle and the skin where the skin was punctured: 90 is square to the skin. The skin is that of the "
     "case, without the probe, averaged over about 15 mm. In the pass that reached the vein, else the last.",
     "30 to 45 degrees are taught (Pepley et al., J Surg Educ 2017, 74:1066); 45 in the thesis"},
    {TipInPicture, "tip_in_picture_percent", 2, "%", Higher,
     "Share of the time from the puncture of the skin to access, or to the end, with the tip under the skin, in which "
     "the live image shows the tip: within its sector and at most one slice thickness (FWHM at the tip's depth) off "
     "its plane. Time with the needle frozen does not count.",
     "Ball et al., Br J Anaesth, doi 10.1093/bja/aer329: 36 % of the time free hand, 90 % with a needle guide"},
    {AspirationWhileAdvancing, "aspiration_while_advancing_percent", 1, "%", Higher,
     "Share of the tip's path forward, until access, on which the syringe aspirates, in steps of 0.5 mm.", kUnnamed},
    {VeinCentreDistance, "vein_centre_distance_mm", 2, "mm", Lower,
     "From the tip to the center line of the vein where the tip last stood in the vein, within 0.5 mm for half a "
     "second; where it never did, at the vein's puncture.",
     kTrainer},
    {TipInVein, "tip_in_vein", 3, "", Higher,
     "1: the attempt ended with the tip in the vein, or with the needle withdrawn after the syringe had aspirated in "
     "the vein for 1 s with the tip within 1 mm of one place, no further wall or bone met; 0: it did not.",
     "Auyong et al., Anesthesiology 2015, 123:535: 76 % against 97 % with a guided needle"},
    {NearestArtery, "nearest_artery_mm", 1, "mm", Higher,
     "Minimum distance of the tip from an artery's wall, under the skin; negative inside.", kUnnamed},
    {NearestLung, "nearest_lung_mm", 1, "mm", Higher,
     "Minimum distance of the tip from lung or airway, under the skin; negative inside.", kUnnamed},
    {ProbePath, "probe_path_mm", 1, "mm", Lower,
     "Path length of the center of the probe's face from the first puncture of the skin until access, in steps of at "
     "least 1 mm.",
     "Weinstein et al., J Vasc Interv Radiol 2023, 34:1337: weak, area under the curve 0.61"},
    {ProbeTranslations, "probe_translations", 1, "", Lower,
     "Movements of the probe faster than 50 mm/s over 50 ms, 0.2 s apart.",
     "Weinstein et al., J Vasc Interv Radiol 2023, 34:1337: area under the curve 0.86"},
    {ProbeRotations, "probe_rotations", 1, "", Lower,
     "Rotations of the probe faster than 50 degrees/s over 50 ms, 0.2 s apart.",
     "Weinstein et al., J Vasc Interv Radiol 2023, 34:1337: area under the curve 0.91"},
    {ProbeForceMean, "probe_force_mean_N", 1, "N", Lower, "Mean force of the probe on the skin while it touches.",
     kUnnamed},
    {ProbeForceMost, "probe_force_max_N", 1, "N", Lower, "Maximum force of the probe on the skin.", kUnnamed},
    {OtherVeinPunctures, "other_vein_punctures", 1, "", Lower,
     "Punctures of a vein that is not the target, counted as those of the target. A case without a target has none.",
     kUnnamed},
    {VeinChecks, "vein_checks", 1, "", Higher,
     "Before the first puncture of the skin: times the target vein lay in the middle of the live image and the probe "
     "compressed it there to less than 40 % of its thickness.",
     "compression tells a vein from an artery before the puncture (Troianos et al., J Am Soc Echocardiogr 2011, "
     "24:1291)"},
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
    "passes",
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
};

}  // namespace

std::string_view metricTitle(Metric metric) {
  return kTitles[static_cast<std::size_t>(metric)];
}

std::span<const MetricDefinition, kMetricCount> metricTable() {
  return kTable;
}

}  // namespace insonate
