#include "../class/ClassWords.h"
#include "../class/HeatColors.h"
#include "ReportPages.h"
#include "ReportParts.h"

#include <insonate/curriculum/AttemptTable.h>
#include <insonate/ui/Text.h>

#include <algorithm>
#include <vector>

namespace insonate::review {
namespace {

using namespace paper;

constexpr double kName = 400, kLevel = 330, kNeeds = 190, kHeadHeight = 410;

QString levelOf(const ClassController& controller, const Member& member) {
  if (!member.standing) return tr("not begun");
  const std::string& level = member.standing->level;
  return level.empty() ? tr("all mastered") : levelTitle(controller.curriculum(), level);
}

void tableHead(PaperColumn& page, double cell) {
  const auto& book = MetricCatalog::instance();
  QPainter& painter = page.painter;
  for (std::size_t i = 0; i < book.comparableCount(); ++i) {
    painter.save();
    painter.translate(kMargin + kName + kLevel + kNeeds + cell * (double(i) + 0.5), page.y() + kHeadHeight);
    painter.rotate(-90);
    painter.setPen(page.ink.text);
    painter.drawText(QRectF(8, -cell / 2, kHeadHeight, cell), Qt::AlignLeft | Qt::AlignVCenter,
                     titleWithUnit(book.all()[i]));
    painter.restore();
  }
  page.skip(kHeadHeight - kRow);
  page.cell(kMargin, kName, tr("person"), page.ink.quiet);
  page.cell(kMargin + kName, kLevel, tr("level"), page.ink.quiet);
  page.cell(kMargin + kName + kLevel, kNeeds, tr("attention"), page.ink.quiet);
  page.skip(kRow + 4);
}

void tableRow(PaperColumn& page, const ClassController& controller, const Member& member, double cell) {
  page.cell(kMargin, kName, QString::fromStdString(member.person.fullName), page.ink.text);
  page.cell(kMargin + kName, kLevel, levelOf(controller, member), page.ink.text);
  page.cell(kMargin + kName + kLevel, kNeeds, attentionWords(*controller.facts(), member), page.ink.danger);
  const auto row = controller.heat().find(member.person.id);
  for (std::size_t i = 0; i < MetricCatalog::instance().comparableCount(); ++i) {
    static const HeatCell kNone;
    const HeatCell& one = row == controller.heat().end() ? kNone : row->second[i];
    const QRectF place(kMargin + kName + kLevel + kNeeds + cell * double(i), page.y() + 2, cell - 3, kRow - 4);
    const QColor ground = one.share ? heatColor(*one.share) : page.ink.ground;
    page.painter.fillRect(place, ground);
    page.painter.setPen(one.share ? inkOn(ground) : page.ink.quiet);
    page.painter.drawText(place, Qt::AlignCenter, one.value ? QString::fromStdString(numberOf(*one.value)) : tr("n/a"));
  }
  page.skip(kRow);
}

}  // namespace

void paintClassReport(QPainter& painter, const ClassController& controller) {
  const ClassFacts& facts = *controller.facts();
  PaperColumn page(painter);
  page.head(QString::fromStdString(facts.cohort.name),
            {countOf(int(facts.learners.size()), tr("person"), tr("people")),
             facts.curriculum ? QString::fromStdString(facts.curriculum->title) : tr("no curriculum yet"),
             tr("means of the last %1 attempts, excluding free practice; a lighter color means a better value")
                 .arg(kLastAttempts)});
  painter.setFont(paperFont(kSmall * 0.9));
  const double cell =
      (kWidth - 2 * kMargin - kName - kLevel - kNeeds) / double(MetricCatalog::instance().comparableCount());
  tableHead(page, cell);
  std::vector<const Member*> people;
  for (const Member& member : facts.learners) people.push_back(&member);
  std::stable_partition(people.begin(), people.end(),
                        [&](const Member* one) { return attentionOf(facts, *one) != Attention::None; });
  std::size_t told = 0;
  for (; told < people.size() && page.hasRoom(2 * kRow); ++told) tableRow(page, controller, *people[told], cell);
  if (told < people.size())
    page.cell(kMargin, kWidth - 2 * kMargin,
              tr("and %1 more people; the table (CSV) lists all people").arg(people.size() - told), page.ink.quiet);
  page.foot();
}

}  // namespace insonate::review
