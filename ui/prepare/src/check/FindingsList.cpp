#include "FindingsList.h"

#include "../model/CaseMeasuring.h"
#include "../model/Crosshair.h"
#include "../model/PlaceProposing.h"
#include "../model/PlacesEditor.h"
#include "../model/PrepareModel.h"
#include "../model/StructureList.h"
#include "../model/TermsEditor.h"

#include <insonate/ui/StateColors.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace insonate::prepare {
namespace {

struct Sign {
  const char* icon;
  QString word, group;
};

Sign needleSymbol(FindingSeverity severity) {
  switch (severity) {
    case FindingSeverity::kError:
      return {"close", FindingsList::tr("Error"), FindingsList::tr("Errors")};
    case FindingSeverity::kWarning:
      return {"warning", FindingsList::tr("Warning"), FindingsList::tr("Warnings")};
    case FindingSeverity::kInfo:
      break;
  }
  return {"help", FindingsList::tr("Note"), FindingsList::tr("Notes")};
}

QString verdict(const std::vector<Finding>& findings) {
  if (!isFitForTraining(findings)) return FindingsList::tr("Not fit for training: correct the errors first.");
  if (findings.empty()) return FindingsList::tr("Fit for training. There are no findings.");
  const bool doubts = findings.front().severity == FindingSeverity::kWarning;
  return doubts ? FindingsList::tr("Fit for training, with warnings: parts of the case may mislead a trainee.")
                : FindingsList::tr("Fit for training.");
}

}  // namespace

QString findingCount(const std::vector<Finding>& findings) {
  const auto count = [&](FindingSeverity s) { return int(std::ranges::count(findings, s, &Finding::severity)); };
  const int errors = count(FindingSeverity::kError), doubts = count(FindingSeverity::kWarning);
  QStringList words;
  if (errors > 0) words << (errors == 1 ? FindingsList::tr("1 error") : FindingsList::tr("%1 errors").arg(errors));
  if (doubts > 0) words << (doubts == 1 ? FindingsList::tr("1 warning") : FindingsList::tr("%1 warnings").arg(doubts));
  return words.isEmpty() ? FindingsList::tr("fit for training") : words.join(QStringLiteral(", "));
}

FindingsList::FindingsList(PrepareModel& shared, QWidget* parent)
    : QWidget(parent),
      shared_(shared),
      state_(new QLabel),
      again_(new QPushButton(tr("Check"))),
      box_(new QVBoxLayout(this)) {
  setObjectName(QStringLiteral("findings"));
  state_->setWordWrap(true);
  state_->setObjectName(QStringLiteral("checkVerdict"));
  again_->setObjectName(QStringLiteral("checkAgain"));
  again_->setToolTip(tr("Measures the structures and checks the case"));
  box_->setContentsMargins(0, 0, 0, 0);
  box_->setSpacing(ui::kGap);
  box_->addWidget(state_);
  box_->addWidget(again_, 0, Qt::AlignLeft);
  connect(again_, &QPushButton::clicked, this, [this] { shared_.measuring.start(); });
  connect(&shared_.measuring, &CaseMeasuring::changed, this, [this] { refresh(); });
  refresh();
}

/// Button that leads to the place of the finding or of its repair; none if it concerns the whole case.
QPushButton* FindingsList::way(const Finding& finding) {
  const auto button = [](const QString& words, const QString& tip) {
    auto* made = new QPushButton(words);
    made->setToolTip(tip);
    return made;
  };
  const std::uint8_t label = finding.label;
  const auto& there = shared_.structures.labels();
  if (label && !finding.place_mm && std::ranges::find(there, label) == there.end()) {
    auto* make =
        button(tr("Label %1").arg(shared_.terms.nameOf(label)), tr("Goes to the step that labels this structure"));
    connect(make, &QPushButton::clicked, this, [this, label] { Q_EMIT labelRequested(label); });
    return make;
  }
  static const std::map<std::string, QString> kMissing{{"no_target", kTargetKind},
                                                       {"no_start_pose", kStartPoseKind},
                                                       {"landmarks_missing", QString()},
                                                       {"no_vessel_names", kVesselKind},
                                                       {"target_without_vessel", kVesselKind}};
  if (const auto missing = kMissing.find(finding.code); missing != kMissing.end()) {
    auto* mark =
        button(tr("Add mark"),
               tr("Opens the list of targets, vessels, landmarks and start poses, where you can add the missing mark"));
    connect(mark, &QPushButton::clicked, this, [this, finding, kind = missing->second] {
      if (finding.place_mm) shared_.crosshair.moveTo(*finding.place_mm);
      shared_.places.requestMark(kind);
    });
    return mark;
  }
  if (!finding.place_mm && !label) return nullptr;
  auto* go = button(finding.place_mm ? tr("Show location") : tr("Select %1").arg(shared_.terms.nameOf(label)),
                    finding.place_mm ? tr("Moves the crosshair to the finding and selects the structure")
                                     : tr("Selects the structure in the table"));
  connect(go, &QPushButton::clicked, this, [this, place_mm = finding.place_mm, label] {
    if (label) shared_.structures.select(label);
    if (place_mm) shared_.crosshair.moveTo(*place_mm);
  });
  return go;
}

QWidget* FindingsList::row(const Finding& finding) {
  const Sign sign = needleSymbol(finding.severity);
  auto* row = new QWidget;
  auto* mark = new QLabel;
  mark->setPixmap(ui::icon(QLatin1String(sign.icon), ui::colorOf(finding.severity)).pixmap(16, 16));
  mark->setToolTip(sign.word);
  mark->setAlignment(Qt::AlignTop);
  auto* text =
      new QLabel(QStringLiteral("<b>%1.</b> %2").arg(sign.word, QString::fromStdString(finding.text).toHtmlEscaped()));
  text->setTextFormat(Qt::RichText);
  text->setWordWrap(true);
  auto* words = new QVBoxLayout;
  words->setSpacing(ui::kSmallGap);
  words->addWidget(text);
  const QString code = QString::fromStdString(finding.code);
  auto* ways = new QHBoxLayout;
  ways->setSpacing(ui::kSmallGap);
  if (finding.code == "no_target" || finding.code == "no_start_pose") {
    QPushButton* propose =
        ui::pushButton(qPrintable(QStringLiteral("propose-") + code), tr("Propose"),
                       tr("Proposes a target in the vein, start poses over the target, and the puncture site"));
    connect(propose, &QPushButton::clicked, &shared_.proposing, &PlaceProposing::start);
    ways->addWidget(propose);
  }
  if (QPushButton* go = way(finding)) {
    go->setObjectName(QStringLiteral("place-") + code);
    ways->addWidget(go);
  }
  for (int n = 0; n < ways->count(); ++n)
    ways->itemAt(n)->widget()->setAccessibleDescription(QString::fromStdString(finding.text));
  ways->addStretch(1);
  words->addLayout(ways);
  auto* box = new QHBoxLayout(row);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kGap);
  box->addWidget(mark, 0, Qt::AlignTop);
  box->addLayout(words, 1);
  return row;
}

void FindingsList::refresh() {
  const CaseMeasuring& measuring = shared_.measuring;
  using State = CaseMeasuring::State;
  again_->setVisible(measuring.state() == State::Stopped);
  const auto& measures = measuring.measures();
  if (!measures) {
    if (list_) list_->deleteLater();
    list_ = nullptr;
    state_->setVisible(true);
    state_->setText(measuring.state() == State::Stopped ? measuring.error() : tr("Checking ..."));
    return;
  }
  state_->setVisible(true);
  state_->setText(verdict(measures->findings));
  // The caller may be a button of this list.
  if (list_) list_->deleteLater();
  list_ = new QWidget;
  auto* rows = new QVBoxLayout(list_);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(ui::kGap);
  std::optional<FindingSeverity> group;
  for (const Finding& finding : measures->findings) {
    if (std::exchange(group, finding.severity) != finding.severity) {
      auto* heading = new QLabel(needleSymbol(finding.severity).group);
      ui::setRole(heading, "heading");
      rows->addWidget(heading);
    }
    rows->addWidget(row(finding));
  }
  box_->addWidget(list_);
}

}  // namespace insonate::prepare
