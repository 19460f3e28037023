#include "ClassWords.h"

#include <insonate/curriculum/Judgement.h>
#include <insonate/ui/Text.h>

#include <QDateTime>
#include <QLocale>
#include <algorithm>

namespace insonate::review {
namespace {

QDateTime timeOf(std::int64_t time_us) {
  return QDateTime::fromMSecsSinceEpoch(time_us / 1000);
}

}  // namespace

QString titleWithUnit(const MetricMeaning& meaning) {
  const QString title = QString::fromStdString(meaning.title);
  return meaning.unit.empty() ? title : QStringLiteral("%1, %2").arg(title, QString::fromStdString(meaning.unit));
}

QString countOf(int count, const QString& one, const QString& many) {
  return QStringLiteral("%1 %2").arg(QString::number(count), count == 1 ? one : many);
}

QString dayOf(std::int64_t time_us) {
  return QLocale(QLocale::English).toString(timeOf(time_us), QStringLiteral("d MMM yyyy"));
}

Attention attentionOf(const ClassFacts& facts, const Member& member) {
  return insonate::attentionOf(member, facts.read_us);
}

QString attentionWords(const ClassFacts& facts, const Member& member) {
  QStringList words{stateWords(facts, member)};
  if (hasImplausible(facts, member)) words << tr("implausible attempt");
  words.removeAll(QString());
  return words.join(QStringLiteral(", "));
}

QString stateWords(const ClassFacts& facts, const Member& member) {
  return QString::fromStdString(insonate::displayText(attentionOf(facts, member), member, facts.read_us));
}

bool hasImplausible(const ClassFacts& facts, const Member& member) {
  return std::ranges::any_of(facts.implausible,
                             [&](const FlaggedAttempt& one) { return one.facts.person == member.person.id; });
}

QString displayText(const AttemptFacts& attempt, const std::vector<Implausible>& flags) {
  return QString::fromStdString(implausibleText(attempt, flags));
}

QString levelTitle(const Curriculum* curriculum, const std::string& level) {
  if (level.empty()) return tr("Free practice");
  const Level* known = curriculum ? curriculum->level(level) : nullptr;
  return QString::fromStdString(known ? known->title : level);
}

QString nameOf(LevelState state) {
  return state == LevelState::Mastered ? tr("mastered")
         : state == LevelState::Open   ? tr("unlocked")
         : state == LevelState::Lapsed ? tr("lapsed")
                                       : tr("locked");
}

QString outcomeOf(const AttemptFacts& attempt, const Curriculum* curriculum) {
  return QString::fromStdString(outcomeWords(attempt, curriculum));
}

}  // namespace insonate::review
