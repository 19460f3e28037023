#include "StructureList.h"

#include "../controls/NumberBox.h"

#include <insonate/tissue/Labels.h>
#include <insonate/ui/Theme.h>

#include <QColorDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPixmap>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>
#include <cmath>

namespace insonate::ui {
namespace {

constexpr int kColorMark_px = 14;

QString nameOf(std::uint8_t label) {
  const std::string_view name = labelTable()[knownLabel(label)].name;
  return label < kLabelCount ? StructureList::tr(std::string(name).c_str()) : StructureList::tr("label %1").arg(label);
}

}  // namespace

StructureList::StructureList(std::shared_ptr<views::SceneView> scene, QWidget* parent)
    : QWidget(parent), scene_(std::move(scene)), box_(new QVBoxLayout(this)), empty_(new QLabel) {
  setObjectName(QStringLiteral("structureList"));
  box_->setContentsMargins(0, 0, 0, 0);
  box_->setSpacing(0);
  empty_->setText(tr("The surfaces of a case appear here."));
  empty_->setWordWrap(true);
  setRole(empty_, "quiet");
  box_->addWidget(empty_);
}

void StructureList::refresh() {
  const auto labels = scene_->structures();
  const bool same = std::equal(labels.begin(), labels.end(), rows_.begin(), rows_.end(),
                               [](std::uint8_t label, const Row& row) { return label == row.label; });
  if (!same) rebuild(labels);
  refreshing_ = true;
  for (const Row& row : rows_) {
    const bool visible = scene_->isVisible(row.label);
    row.eye->setChecked(visible);
    const bool seen = visible && scene_->opacity(row.label) > 0;
    row.eye->setIcon(icon(visible ? QStringLiteral("eye") : QStringLiteral("eye-off"),
                          seen ? views::theme::kText : views::theme::kQuiet));
    row.eye->setToolTip(visible && !seen ? tr("%1 is invisible: its opacity is 0 %").arg(nameOf(row.label))
                                         : tr("Show or hide %1").arg(nameOf(row.label)));
    QPixmap swatch(kColorMark_px, kColorMark_px);
    swatch.fill(toQColor(scene_->color(row.label)));
    row.color->setIcon(swatch);
    row.opacity->setValue(int(std::lround(scene_->opacity(row.label) * 100)));
    row.opacity->setEnabled(visible);
  }
  refreshing_ = false;
}

void StructureList::rebuild(const std::vector<std::uint8_t>& labels) {
  for (const Row& row : rows_) {
    row.widget->hide();
    row.widget->deleteLater();
  }
  rows_.clear();
  for (const std::uint8_t label : labels) {
    rows_.push_back(makeRow(label));
    box_->addWidget(rows_.back().widget);
  }
  empty_->setVisible(rows_.empty());
}

StructureList::Row StructureList::makeRow(std::uint8_t label) {
  const QString name = nameOf(label);
  auto* widget = new QWidget(this);
  Row row{label, widget, new QToolButton(widget), new QToolButton(widget),
          new NumberBox<QSpinBox>(tr("Opacity of %1").arg(name), widget)};
  auto* box = new QHBoxLayout(widget);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(2);
  row.eye->setCheckable(true);
  row.eye->setObjectName(QStringLiteral("eye%1").arg(label));
  row.eye->setAccessibleName(tr("Show %1").arg(name));
  row.color->setObjectName(QStringLiteral("colour%1").arg(label));
  row.color->setAccessibleName(tr("Color of %1").arg(name));
  row.color->setToolTip(tr("Color of %1").arg(name));
  row.opacity->setObjectName(QStringLiteral("opacity%1").arg(label));
  row.opacity->setRange(0, 100);
  row.opacity->setSingleStep(5);
  row.opacity->setSuffix(tr(" %"));
  row.opacity->setAlignment(Qt::AlignRight);
  row.opacity->setButtonSymbols(QAbstractSpinBox::NoButtons);
  row.opacity->setFixedWidth(64);
  row.opacity->setAccessibleName(tr("Opacity of %1 in %").arg(name));
  row.opacity->setToolTip(tr("Opacity of %1, 0 to 100 %; arrow keys change it").arg(name));
  connect(row.eye, &QToolButton::clicked, this, [this, label](bool visible) {
    scene_->setVisible(label, visible);
    Q_EMIT changed();
  });
  connect(row.color, &QToolButton::clicked, this, [this, label] { chooseColor(label); });
  connect(row.opacity, qOverload<int>(&QSpinBox::valueChanged), this, [this, label](int percent) {
    if (refreshing_) return;
    scene_->setOpacity(label, percent / 100.0);
    Q_EMIT changed();
  });
  box->addWidget(row.eye);
  box->addWidget(row.color);
  box->addWidget(new QLabel(name, widget), 1);
  box->addWidget(row.opacity);
  // The panel has a separate slider for the transparency of the skin.
  if (label == kSkin) row.opacity->hide();
  return row;
}

void StructureList::chooseColor(std::uint8_t label) {
  auto* dialog = new QColorDialog(toQColor(scene_->color(label)), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Color of %1").arg(nameOf(label)));
  connect(dialog, &QColorDialog::colorSelected, this, [this, label](const QColor& chosen) {
    scene_->setColor(label, {std::uint8_t(chosen.red()), std::uint8_t(chosen.green()), std::uint8_t(chosen.blue())});
    Q_EMIT changed();
    Q_EMIT colorChanged();
  });
  dialog->open();
}

}  // namespace insonate::ui
