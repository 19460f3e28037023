#include "AttemptWords.h"

#include <QCoreApplication>
#include <cmath>

namespace insonate::train {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("AttemptWords", text);
}

const MetricDefinition& definitionOf(Metric metric) {
  return metricTable()[std::size_t(metric)];
}

}  // namespace

PlaceWords wordsOf(NeedlePlace place) {
  switch (place) {
    case NeedlePlace::Clean:
      return {QStringLiteral("○"), tr("needle new"), views::theme::kText};
    case NeedlePlace::Underway:
      return {QStringLiteral("◐"), tr("in tissue"), views::theme::kText};
    case NeedlePlace::Vein:
      return {QStringLiteral("●"), tr("in the vein"), views::theme::kGood};
    case NeedlePlace::WrongPlace:
      return {QStringLiteral("▲"), tr("wrong place"), views::theme::kDanger};
    case NeedlePlace::Used:
      return {QStringLiteral("■"), tr("needle used"), views::theme::kCaution};
  }
  return {};
}

NeedlePlace plainly(NeedlePlace place) {
  const bool inside = place == NeedlePlace::Vein || place == NeedlePlace::WrongPlace;
  return inside ? NeedlePlace::Underway : place;
}

QString nameOf(Metric metric) {
  switch (metric) {
    case Metric::VeinPunctures:
      return tr("vein");
    case Metric::ArteryPunctures:
      return tr("artery");
    case Metric::DoublePunctures:
      return tr("back wall");
    case Metric::TimeToVein:
      return tr("skin to vein");
    case Metric::UsedNeedleInsertions:
      return tr("used needle");
    case Metric::Passes:
      return tr("passes");
    case Metric::Redirections:
      return tr("redirections");
    case Metric::InsertionAngle:
      return tr("angle to the skin");
    case Metric::TipInPicture:
      return tr("tip in the picture");
    case Metric::AspirationWhileAdvancing:
      return tr("drawing on the way in");
    case Metric::NeedlePath:
      return tr("needle's way");
    case Metric::NearestArtery:
      return tr("nearest artery");
    case Metric::ProbeForceMost:
      return tr("most force of the probe");
    default:
      return QString::fromUtf8(definitionOf(metric).id.data(), int(definitionOf(metric).id.size())).replace('_', ' ');
  }
}

QString valueOf(Metric metric, const MetricValues& values) {
  const auto value = values[metric];
  if (!value) return QStringLiteral("–");
  const std::string_view unit = definitionOf(metric).unit;
  if (unit.empty()) return QString::number(std::lround(*value));
  if (unit == "deg") return QStringLiteral("%1°").arg(*value, 0, 'f', 0);
  return QStringLiteral("%1 %2")
      .arg(*value, 0, 'f', unit == "%" ? 0 : 1)
      .arg(QString::fromUtf8(unit.data(), int(unit.size())));
}

views::Colour colourOf(Severity severity) {
  switch (severity) {
    case Severity::Critical:
      return views::theme::kDanger;
    case Severity::Major:
      return views::theme::kCaution;
    case Severity::Minor:
      break;
  }
  return views::theme::kQuiet;
}

QString wordOf(Severity severity) {
  switch (severity) {
    case Severity::Critical:
      return tr("Critical");
    case Severity::Major:
      return tr("Major");
    case Severity::Minor:
      break;
  }
  return tr("Minor");
}

QString clockOf(double time_s) {
  const int whole = int(time_s);
  return QStringLiteral("%1:%2").arg(whole / 60).arg(whole % 60, 2, 10, QLatin1Char('0'));
}

QString headlineOf(const AttemptScore& score, AttemptStatus status) {
  if (status == AttemptStatus::Abandoned) return tr("Abandoned");
  const QString end = score.succeeded ? tr("the vein was reached") : tr("the goal was not reached");
  return score.points ? tr("%1 of 100: %2").arg(std::lround(*score.points)).arg(end) : tr("No score: %1").arg(end);
}

}  // namespace insonate::train
