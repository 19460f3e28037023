#include "ClippingControls.h"
#include "EyeControls.h"
#include "StructureList.h"

#include <insonate/tissue/Labels.h>
#include <insonate/ui/HistogramEditor.h>
#include <insonate/ui/ScenePanel.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/ValueSlider.h>
#include <insonate/ui/Widgets.h>

#include <QCheckBox>
#include <QHBoxLayout>
#include <QScrollArea>
#include <QSettings>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

namespace insonate::ui {
namespace {

constexpr int kRest_ms = 350;

QVBoxLayout* column(QWidget* widget) {
  auto* box = new QVBoxLayout(widget);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(kSmallGap);
  return box;
}

/// A case that was saved or edited is still the same patient.
bool samePatient(const PatientCase& a, const PatientCase& b) {
  return a.ct.geometry == b.ct.geometry && a.manifest.source == b.manifest.source;
}

}  // namespace

ScenePanel::ScenePanel(std::shared_ptr<views::SceneView> scene, QWidget* parent, Structures structures)
    : QWidget(parent), scene_(std::move(scene)), structuresHere_(structures == Structures::Here) {
  setObjectName(QStringLiteral("scenePanel"));
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(12, kGap, 12, kGap);
  box->setSpacing(12);
  skin_ = new ValueSlider(tr("skin transparency"), tr("%"), {0, 100, 65, 5, 0}, tr("Transparency of the skin"));
  skin_->setObjectName(QStringLiteral("skinTransparency"));
  box->addWidget(skin_);
  QWidget* list = buildStructures();
  box->addWidget(list);
  for (QWidget* part : {static_cast<QWidget*>(skin_), list}) part->setVisible(structuresHere_);
  box->addWidget(buildCt());
  clipping_ = new ClippingControls(scene_);
  box->addWidget(heading(tr("Clipping plane")));
  box->addWidget(clipping_);
  eyes_ = new EyeControls(scene_);
  box->addWidget(heading(tr("Stereo and eye position")));
  box->addWidget(eyes_);
  box->addStretch();

  rest_.setSingleShot(true);
  rest_.setInterval(kRest_ms);
  connect(&rest_, &QTimer::timeout, this, [this] { scene_->setMoving(false); });
  connect(skin_, &ValueSlider::valueChanged, this, [this](double percent) {
    if (refreshing_) return;
    scene_->setSkinOpacity(1 - percent / 100);
    live();
  });
  connect(structures_, &StructureList::changed, this, &ScenePanel::live);
  connect(structures_, &StructureList::colorChanged, this, &ScenePanel::colorsChanged);
  connect(clipping_, &ClippingControls::changed, this, &ScenePanel::live);
  connect(eyes_, &EyeControls::changed, this, &ScenePanel::live);
  scene_->setStructuresChanged([this] {
    // Loading a case changes many things at once.
    if (refreshDue_) return;
    refreshDue_ = true;
    QTimer::singleShot(0, this, &ScenePanel::refresh);
  });
  refresh();
}

ScenePanel::~ScenePanel() {
  scene_->setStructuresChanged({});
}

QWidget* ScenePanel::buildStructures() {
  auto* part = new QWidget;
  auto* box = column(part);
  auto* row = new QHBoxLayout;
  row->setSpacing(0);
  row->addWidget(heading(tr("Structures")), 1);
  const auto add = [&](const char* object, const QString& text, const QString& tip, auto act) {
    auto* button = new QToolButton;
    button->setObjectName(QLatin1String(object));
    button->setText(text);
    button->setToolTip(tip);
    connect(button, &QToolButton::clicked, this, act);
    row->addWidget(button);
  };
  const auto showAll = [this](bool visible) {
    for (const std::uint8_t label : scene_->structures()) scene_->setVisible(label, visible);
    live();
  };
  add("structuresAll", tr("all"), tr("Show all structures"), [showAll] { showAll(true); });
  add("structuresNone", tr("none"), tr("Hide all structures"), [showAll] { showAll(false); });
  add("structuresUsual", tr("standard"),
      tr("Shows structures as chosen by the author of the case, otherwise all structures with default colors and "
         "opacities"),
      [this] { restoreDefaults(); });
  box->addLayout(row);
  structures_ = new StructureList(scene_);
  box->addWidget(structures_);
  safeColors_ = new QCheckBox(tr("color-blind safe colors"));
  safeColors_->setObjectName(QStringLiteral("safeColours"));
  safeColors_->setToolTip(tr("Uses colors that people with red-green color blindness can distinguish"));
  connect(safeColors_, &QCheckBox::clicked, this, [this](bool safe) {
    setColorScheme(safe ? views::ColorScheme::ColorBlindSafe : views::ColorScheme::Default);
  });
  box->addWidget(safeColors_);
  return part;
}

QWidget* ScenePanel::buildCt() {
  auto* part = new QWidget;
  auto* box = column(part);
  ct_ = new QCheckBox(tr("CT volume"));
  ct_->setObjectName(QStringLiteral("ctVolume"));
  ct_->setToolTip(tr("Draws the CT as a volume with the chosen transfer function"));
  histogram_ = new HistogramEditor;
  histogram_->setFunction(scene_->transferFunction());
  box->addWidget(ct_);
  box->addWidget(histogram_);
  connect(ct_, &QCheckBox::clicked, this, [this](bool visible) {
    scene_->setCtVisible(visible);
    histogram_->setVisible(visible);
    live();
    if (visible) QTimer::singleShot(0, this, &ScenePanel::scrollToHistogram);
  });
  connect(histogram_, &HistogramEditor::functionChanged, this, [this](const views::TransferFunction& function) {
    scene_->setTransferFunction(function);
    live();
  });
  return part;
}

ScenePanel::Look ScenePanel::look(std::uint8_t label) const {
  return {scene_->color(label), scene_->opacity(label), scene_->isVisible(label)};
}

void ScenePanel::setLook(std::uint8_t label, const Look& look) {
  scene_->setColor(label, look.color);
  scene_->setOpacity(label, look.opacity);
  scene_->setVisible(label, look.visible);
}

views::Color ScenePanel::caseColor(std::uint8_t label) const {
  const bool chosen = patient_ && patient_->colors.contains(label);
  if (!structuresHere_ || !chosen || scheme_ != views::ColorScheme::Default) return views::labelColor(label, scheme_);
  const LabelColor color = caseLabelColor(patient_->colors, label);
  return {color[0], color[1], color[2]};
}

/// Replaces the choices of the former case by those of this one.
void ScenePanel::takeLooks() {
  for (const auto& [label, own] : own_) setLook(label, own);
  own_.clear();
  if (patient_) {
    for (const auto& [label, color] : patient_->colors) {
      own_.try_emplace(label, look(label));
      if (scheme_ == views::ColorScheme::Default) scene_->setColor(label, caseColor(label));
    }
    for (const auto& [label, shown] : patient_->manifest.shown) {
      own_.try_emplace(label, look(label));
      scene_->setOpacity(label, shown.opacity);
      scene_->setVisible(label, shown.visible);
    }
  }
  Q_EMIT colorsChanged();
}

/// Structures hidden to look into one patient must not be missing in the next.
void ScenePanel::showAnother() {
  scene_->setCtVisible(false);
  if (structuresHere_) scene_->setVisible(kSkin, true);
}

void ScenePanel::setCase(std::shared_ptr<const PatientCase> patient) {
  if (patient && (!last_ || !samePatient(*last_, *patient))) showAnother();
  patient_ = patient;
  if (patient_) last_ = patient_;
  if (structuresHere_) takeLooks();
  histogram_->setCase(std::move(patient));
  scene_->setClipping({});
  clipping_->refresh();
  refresh();
}

void ScenePanel::refresh() {
  refreshDue_ = false;
  refreshing_ = true;
  const auto labels = scene_->structures();
  skin_->setValue(100 * (1 - scene_->opacity(kSkin)));
  skin_->setEnabled(std::find(labels.begin(), labels.end(), kSkin) != labels.end() && scene_->isVisible(kSkin));
  structures_->refresh();
  safeColors_->setChecked(scheme_ == views::ColorScheme::ColorBlindSafe);
  ct_->setChecked(scene_->isCtVisible());
  histogram_->setVisible(scene_->isCtVisible());
  refreshing_ = false;
}

void ScenePanel::scrollToHistogram() {
  for (QWidget* parent = parentWidget(); parent; parent = parent->parentWidget())
    if (auto* scroll = qobject_cast<QScrollArea*>(parent)) return scroll->ensureWidgetVisible(histogram_, 0, kGap);
}

void ScenePanel::live() {
  scene_->setMoving(true);
  rest_.start();
}

void ScenePanel::setColorScheme(views::ColorScheme scheme) {
  scheme_ = scheme;
  for (const LabelInfo& info : labelTable()) scene_->setColor(info.label, caseColor(info.label));
  // The user's new colors also hold after this case.
  for (auto& [label, own] : own_) own.color = views::labelColor(label, scheme);
  safeColors_->setChecked(scheme == views::ColorScheme::ColorBlindSafe);
  Q_EMIT colorsChanged();
}

void ScenePanel::restoreDefaults() {
  for (const LabelInfo& info : labelTable()) {
    scene_->setVisible(info.label, true);
    scene_->setOpacity(info.label, views::defaultOpacity(info.label));
  }
  if (patient_ && structuresHere_) {
    for (const auto& [label, shown] : patient_->manifest.shown) {
      scene_->setVisible(label, shown.visible);
      scene_->setOpacity(label, shown.opacity);
    }
  }
  setColorScheme(scheme_);
  live();
}

void ScenePanel::showEvent(QShowEvent* event) {
  // The scene may enter its window only now.
  eyes_->refresh();
  clipping_->refresh();
  QWidget::showEvent(event);
}

void ScenePanel::save(QSettings& settings) const {
  QStringList looks;
  for (const LabelInfo& info : labelTable()) {
    const auto own = own_.find(info.label);
    const Look kept = own == own_.end() ? look(info.label) : own->second;
    looks << QStringLiteral("%1 %2 %3").arg(int(kept.visible)).arg(kept.opacity).arg(ui::toQColor(kept.color).name());
  }
  if (structuresHere_) settings.setValue(QStringLiteral("structures"), looks);
  settings.setValue(QStringLiteral("safeColours"), scheme_ == views::ColorScheme::ColorBlindSafe);
  settings.setValue(QStringLiteral("ctVolume"), scene_->isCtVisible());
  settings.setValue(QStringLiteral("transferFunction"),
                    QString::fromStdString(views::writeTransferFunction(scene_->transferFunction())));
  eyes_->save(settings);
}

void ScenePanel::restore(QSettings& settings) {
  scheme_ = settings.value(QStringLiteral("safeColours")).toBool() ? views::ColorScheme::ColorBlindSafe
                                                                   : views::ColorScheme::Default;
  const QStringList looks =
      structuresHere_ ? settings.value(QStringLiteral("structures")).toStringList() : QStringList();
  for (int label = 0; label < std::min(looks.size(), kLabelCount); ++label) {
    const QStringList parts = looks[label].split(QLatin1Char(' '));
    const QColor color(parts.size() == 3 ? parts[2] : QString());
    if (!color.isValid()) continue;
    scene_->setVisible(std::uint8_t(label), parts[0] != QLatin1String("0"));
    scene_->setOpacity(std::uint8_t(label), std::clamp(parts[1].toDouble(), 0.0, 1.0));
    scene_->setColor(std::uint8_t(label),
                     {std::uint8_t(color.red()), std::uint8_t(color.green()), std::uint8_t(color.blue())});
  }
  const auto function =
      views::readTransferFunction(settings.value(QStringLiteral("transferFunction")).toString().toStdString());
  if (function && !function->nodes.empty()) histogram_->setFunction(*function);
  scene_->setCtVisible(settings.value(QStringLiteral("ctVolume"), false).toBool());
  eyes_->restore(settings);
  refresh();
  Q_EMIT colorsChanged();
}

}  // namespace insonate::ui
