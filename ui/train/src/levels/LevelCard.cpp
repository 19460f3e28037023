#include "LevelCard.h"

#include "../attempt/AttemptWords.h"
#include "LevelControl.h"
#include "LevelWords.h"
#include "TestAdmissions.h"
#include "TestEntryDialog.h"

#include <insonate/ui/PlainToolTip.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

namespace insonate::train {
namespace {

QPushButton* levelButton(const char* object, const QString& text, const QString& says) {
  return ui::pushButton(object, text, says, Qt::TabFocus);
}

}  // namespace

LevelCard::LevelCard(LevelControl& levels, TestAdmissions& admissions, const QString& showLevels, QWidget* parent)
    : QWidget(parent),
      levels_(levels),
      admissions_(admissions),
      title_(ui::paragraph("levelTitle", "heading")),
      rule_(ui::paragraph("levelRule", "quiet")),
      test_(ui::paragraph("levelTestState")) {
  auto* course = levelButton("levelsOpen", tr("Levels"), showLevels);
  open_ = levelButton("levelOpenCase", tr("Open Case"), tr("Opens the case of the level in place of the present case"));
  free_ = levelButton("levelLeave", tr("Free practice"),
                      tr("Leaves the level; you can then choose any case, procedure and assistance"));
  code_ = levelButton("levelCode", tr("Enter Code"), tr("Enter the code of the test, which your instructor gave you"));
  auto* row = new QHBoxLayout;
  row->setSpacing(ui::kSmallGap);
  for (QPushButton* one : {course, open_, code_, free_}) row->addWidget(one, 1);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kSmallGap);
  box->addWidget(title_);
  box->addWidget(rule_);
  box->addWidget(test_);
  box->addLayout(row);
  connect(course, &QPushButton::clicked, this, &LevelCard::courseRequested);
  connect(open_, &QPushButton::clicked, &levels_, &LevelControl::openCase);
  connect(free_, &QPushButton::clicked, &levels_, &LevelControl::leave);
  connect(code_, &QPushButton::clicked, this, [this] {
    if (levels_.level()) (new TestEntryDialog(admissions_, *levels_.level(), this))->open();
  });
  connect(&levels_, &LevelControl::changed, this, [this] { refresh(); });
  connect(&admissions_, &TestAdmissions::changed, this, [this] { refresh(); });
  refresh();
}

void LevelCard::refresh() {
  const Level* level = levels_.level();
  title_->setVisible(level);
  rule_->setVisible(level);
  free_->setVisible(level);
  open_->setVisible(levels_.waitsForCase());
  test_->setText(level ? admissions_.findingText(*level) : QString());
  test_->setVisible(!test_->text().isEmpty());
  const auto admission = level ? admissions_.of(*level) : std::nullopt;
  code_->setVisible(admission && admission->kind == TestAdmission::Kind::NeedsCode);
  if (!level) return;
  title_->setText(QString::fromStdString(level->title));
  rule_->setText(tr("%1. To pass: %2.").arg(capital(assistanceText(level->assistance)), passOf(level->pass)));
  QStringList limits;
  for (const MetricStandard& standard : level->pass.standards) limits << limitOf(standard);
  rule_->setToolTip(ui::plainToolTip(limits.join(QLatin1Char('\n'))));
}

}  // namespace insonate::train
