#include "VerdictView.h"

#include "LevelWords.h"

#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QLabel>
#include <QVBoxLayout>

namespace insonate::train {
namespace {

QString verdictSign(const QString& sign, views::Color color) {
  return QStringLiteral("<span style='color:%1'>%2</span>").arg(ui::toQColor(color).name(), sign);
}

void showText(QLabel& label, const QString& text) {
  label.setText(text);
  label.setVisible(!text.isEmpty());
}

}  // namespace

VerdictView::VerdictView(QWidget* parent)
    : QWidget(parent),
      headline_(ui::paragraph("levelVerdict")),
      standards_(ui::paragraph("levelStandards")),
      changes_(ui::paragraph("levelChanges")) {
  ui::setRole(headline_, "heading");
  headline_->setTextFormat(Qt::RichText);
  standards_->setTextFormat(Qt::RichText);
  changes_->setTextFormat(Qt::PlainText);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kSmallGap);
  for (QLabel* one : {headline_, standards_, changes_}) box->addWidget(one);
}

void VerdictView::show(const Verdict& verdict) {
  const QString sign = verdict.passed ? verdictSign(QStringLiteral("✓"), views::theme::kGood)
                                      : verdictSign(QStringLiteral("▲"), views::theme::kCaution);
  showText(*headline_, sign + QStringLiteral("&nbsp; ") + verdict.headline.toHtmlEscaped());
  QStringList lines;
  for (const QString& one : verdict.missed)
    lines << verdictSign(QStringLiteral("✗"), views::theme::kDanger) + QStringLiteral("&nbsp; ") + one.toHtmlEscaped();
  if (!verdict.met.isEmpty())
    lines << (verdict.passed ? verdictSign(QStringLiteral("✓"), views::theme::kGood) : QStringLiteral("·")) +
                 tr("&nbsp; %1 of %2 standards met")
                     .arg(verdict.met.size())
                     .arg(verdict.met.size() + verdict.missed.size());
  showText(*standards_, lines.join(QStringLiteral("<br>")));
  standards_->setToolTip(verdict.met.isEmpty() ? QString() : tr("Met: %1").arg(verdict.met.join(QStringLiteral("; "))));
  showText(*changes_, verdict.changes.join(QLatin1Char('\n')));
}

void VerdictView::show(const QString& sentence) {
  showText(*headline_, {});
  showText(*standards_, {});
  showText(*changes_, sentence);
}

}  // namespace insonate::train
