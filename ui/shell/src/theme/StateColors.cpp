#include <insonate/ui/StateColors.h>

namespace insonate::ui {

namespace theme = views::theme;

views::Color colorOf(NeedlePlace place) {
  switch (place) {
    case NeedlePlace::Clean:
    case NeedlePlace::UnderSkin:
      return theme::kText;
    case NeedlePlace::Vein:
      return theme::kGood;
    case NeedlePlace::WrongPlace:
      return theme::kDanger;
    case NeedlePlace::Used:
      break;
  }
  return theme::kCaution;
}

views::Color colorOf(const std::optional<Severity>& severity) {
  if (!severity) return theme::kQuiet;
  return *severity == Severity::Minor   ? theme::kAccent
         : *severity == Severity::Major ? theme::kCaution
                                        : theme::kDanger;
}

views::Color colorOf(CheckState state) {
  switch (state) {
    case CheckState::Passed:
      return theme::kGood;
    case CheckState::Warnings:
      return theme::kCaution;
    case CheckState::Failed:
      return theme::kDanger;
    case CheckState::Unknown:
      break;
  }
  return theme::kQuiet;
}

views::Color colorOf(FindingSeverity severity) {
  return severity == FindingSeverity::kError     ? theme::kDanger
         : severity == FindingSeverity::kWarning ? theme::kCaution
                                                 : theme::kQuiet;
}

views::Color colorOf(LabelState state) {
  switch (state) {
    case LabelState::InProgress:
      return theme::kText;
    case LabelState::Completed:
      return theme::kGood;
    case LabelState::Flagged:
      return theme::kCaution;
    default:
      return theme::kQuiet;
  }
}

views::Color colorOf(StepState state) {
  switch (state) {
    case StepState::Working:
      return theme::kAccent;
    case StepState::Done:
      return theme::kGood;
    case StepState::Warning:
      return theme::kCaution;
    default:
      return theme::kText;
  }
}

}  // namespace insonate::ui
