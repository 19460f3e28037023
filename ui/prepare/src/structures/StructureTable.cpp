#include "StructureTable.h"

#include "../labels/LabelSession.h"
#include "../model/OpenCase.h"
#include "../model/PrepareModel.h"
#include "../model/StructureAppearance.h"
#include "../model/StructureList.h"
#include "../model/TermsEditor.h"
#include "LabelDetails.h"
#include "StructureModel.h"

#include <insonate/tissue/OwnLabels.h>
#include <insonate/ui/Commands.h>
#include <insonate/ui/LetterKeyFilter.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/ValueSlider.h>

#include <QColorDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMenu>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

namespace insonate::prepare {
namespace {

constexpr int kRow_px = 26, kIconColumn_px = 25, kVolumeColumn_px = 70;
/// Widths of the columns that a wide table adds; they also determine when these are shown.
constexpr int kStateColumn_px = 128, kTissueColumn_px = 130, kVoxelsColumn_px = 108;
constexpr int kRoomForState_px = 380, kRoomForTissue_px = 500, kRoomForAll_px = 880;
constexpr double kPercent = 100;

}  // namespace

StructureTable::StructureTable(PrepareModel& shared, const ui::Commands& commands)
    : shared_(shared),
      commands_(commands),
      model_(new StructureModel(shared, this)),
      table_(new QTableView),
      opacity_(new ui::ValueSlider(tr("in 3D"), QStringLiteral("%"), {0, kPercent, kPercent, 5, 0},
                                   tr("opacity of the selected structure in 3D"))),
      onSlices_(new ui::ValueSlider(
          tr("on slices"), QStringLiteral("%"), {0, kPercent, kPercent, 5, 0},
          tr("opacity of the selected structure on slices, relative to the overall label opacity"))) {
  buildTable();
  opacity_->setObjectName(QStringLiteral("structureOpacity"));
  onSlices_->setObjectName(QStringLiteral("structureOnSlices"));
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kGap);
  box->addWidget(table_, 1);
  box->addWidget(new LabelDetails(shared_));
  auto* opacities = new QHBoxLayout;
  opacities->setSpacing(ui::kGap);
  opacities->addWidget(opacity_);
  opacities->addWidget(onSlices_);
  box->addLayout(opacities);
  box->addWidget(buildButtons());
  connect(opacity_, &ui::ValueSlider::valueChanged, this, [this](double percent) {
    if (!showing_) shared_.appearance.setOpacity(shared_.structures.selected(), percent / kPercent);
  });
  connect(onSlices_, &ui::ValueSlider::valueChanged, this, [this](double percent) {
    if (!showing_) shared_.appearance.setShareOnSlices(shared_.structures.selected(), percent / kPercent);
  });
  connect(&shared_.structures, &StructureList::changed, this, [this] { showSelected(); });
  connect(&shared_.structures, &StructureList::selectedChanged, this, [this] { showSelected(); });
  connect(&shared_.appearance, &StructureAppearance::lookChanged, this, [this](int label) {
    if (label == shared_.structures.selected()) showSelected();
  });
  showSelected();
}

void StructureTable::buildTable() {
  table_->setObjectName(QStringLiteral("structures"));
  table_->setAccessibleName(tr("Structures of the label map"));
  table_->setModel(model_);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setShowGrid(false);
  table_->setTabKeyNavigation(false);
  table_->setMinimumHeight(4 * kRow_px);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(kRow_px);
  table_->verticalHeader()->setMinimumSectionSize(kRow_px);
  QHeaderView* header = table_->horizontalHeader();
  header->setHighlightSections(false);
  header->setMinimumSectionSize(kIconColumn_px);
  header->setSectionResizeMode(QHeaderView::Fixed);
  header->setSectionResizeMode(StructureModel::kName, QHeaderView::Stretch);
  for (const auto column : {StructureModel::kEye, StructureModel::kLock, StructureModel::kColor})
    header->resizeSection(column, kIconColumn_px);
  header->resizeSection(StructureModel::kVolume, kVolumeColumn_px);
  header->resizeSection(StructureModel::kTissue, kTissueColumn_px);
  // Names and terms share the remaining width.
  header->setSectionResizeMode(StructureModel::kTerm, QHeaderView::Stretch);
  header->resizeSection(StructureModel::kVoxels, kVoxelsColumn_px);
  table_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  showColumns();
  new ui::LetterKeyFilter(table_);
  table_->installEventFilter(this);
  connect(table_, &QTableView::clicked, this, [this](const QModelIndex& index) { clicked(index); });
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& index) {
    if (!showing_ && index.isValid()) shared_.structures.select(model_->labelAt(index.row()));
  });
}

/// As many columns as fit; the text below has the content of the others.
void StructureTable::showColumns() {
  const int room_px = width();
  model_->setRoomy(room_px >= kRoomForState_px);
  table_->horizontalHeader()->resizeSection(StructureModel::kState,
                                            room_px >= kRoomForState_px ? kStateColumn_px : kIconColumn_px);
  table_->setColumnHidden(StructureModel::kTissue, room_px < kRoomForTissue_px);
  for (const auto column : {StructureModel::kTerm, StructureModel::kVoxels})
    table_->setColumnHidden(column, room_px < kRoomForAll_px);
}

void StructureTable::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  showColumns();
}

QWidget* StructureTable::buildButtons() {
  auto* row = new QWidget;
  auto* box = new QHBoxLayout(row);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kSmallGap);
  only_ = new QPushButton(tr("Isolate"));
  only_->setObjectName(QStringLiteral("showOnly"));
  only_->setToolTip(tr("Hides every structure but the selected one"));
  all_ = new QPushButton(tr("All"));
  all_->setObjectName(QStringLiteral("showAll"));
  all_->setToolTip(tr("Shows every structure"));
  auto* add = new QPushButton(tr("Add"));
  add->setObjectName(QStringLiteral("addLabel"));
  add->setToolTip(tr("Adds another structure to label"));
  auto* menu = new QMenu(add);
  menu->setToolTipsVisible(true);
  connect(menu, &QMenu::aboutToShow, this, [this, menu] { fillAdd(*menu); });
  add->setMenu(menu);
  remove_ = new QPushButton(tr("Clear"));
  remove_->setObjectName(QStringLiteral("clearLabel"));
  remove_->setToolTip(
      tr("Changes all voxels of the selected structure to soft tissue; a structure that you added and that has no "
         "voxels is removed from the list. Ctrl+Z undoes it"));
  connect(remove_, &QPushButton::clicked, this,
          [this] { shared_.structures.removeVoxels(shared_.structures.selected()); });
  connect(only_, &QPushButton::clicked, this, [this] { shared_.appearance.showOnly(shared_.structures.selected()); });
  connect(all_, &QPushButton::clicked, this, [this] { shared_.appearance.showAll(); });
  for (QPushButton* button : {add, remove_, only_, all_}) {
    button->setMinimumWidth(0);
    box->addWidget(button, 1);
  }
  return row;
}

void StructureTable::clicked(const QModelIndex& index) {
  const std::uint8_t label = model_->labelAt(index.row());
  shared_.structures.select(label);
  if (index.column() == StructureModel::kEye)
    shared_.appearance.setVisible(label, !shared_.appearance.look(label).visible);
  if (index.column() == StructureModel::kColor) chooseColor();
  if (index.column() == StructureModel::kState) shared_.structures.toNextState(label);
  if (index.column() == StructureModel::kLock)
    shared_.labeling.setLocked(label, !shared_.labeling.rules().locked.test(label));
}

void StructureTable::fillAdd(QMenu& menu) {
  menu.clear();
  const auto& there = shared_.structures.labels();
  for (const LabelInfo& info : labelTable()) {
    if (info.label == kBackground || std::ranges::find(there, info.label) != there.end()) continue;
    QAction* action = menu.addAction(shared_.terms.nameOf(info.label), this,
                                     [this, label = info.label] { shared_.structures.add(label); });
    action->setToolTip(termOf(info.label));
  }
  int next = kLabelCount;
  while (std::ranges::find(there, std::uint8_t(next)) != there.end()) ++next;
  if (next > kLastOwnLabel) return;
  menu.addSeparator();
  QAction* another = menu.addAction(tr("Another structure ..."), this, [this, next] {
    shared_.structures.add(std::uint8_t(next));
    rename();
  });
  another->setToolTip(
      tr("Adds a structure of your own, with name, color and tissue; its label number is %1").arg(next));
}

void StructureTable::rename() {
  const int row = model_->rowOf(shared_.structures.selected());
  if (row < 0) return;
  table_->setFocus();
  table_->edit(model_->index(row, StructureModel::kName));
}

void StructureTable::chooseColor() {
  const std::uint8_t label = shared_.structures.selected();
  if (model_->rowOf(label) < 0) return;
  auto* dialog = new QColorDialog(ui::toQColor(shared_.appearance.look(label).color), this);
  dialog->setObjectName(QStringLiteral("structureColour"));
  dialog->setWindowTitle(tr("Color of %1").arg(shared_.terms.nameOf(label)));
  dialog->setOption(QColorDialog::DontUseNativeDialog);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QColorDialog::colorSelected, this, [this, label](const QColor& c) {
    shared_.appearance.setColor(label, {std::uint8_t(c.red()), std::uint8_t(c.green()), std::uint8_t(c.blue())});
  });
  // A color of this case does not apply to the next one.
  connect(&shared_.openCase, &OpenCase::caseChanged, dialog, &QDialog::reject);
  dialog->open();
}

void StructureTable::showSelected() {
  showing_ = true;
  const std::uint8_t label = shared_.structures.selected();
  const int row = model_->rowOf(label);
  if (row >= 0) table_->setCurrentIndex(model_->index(row, StructureModel::kName));
  for (QWidget* one : {static_cast<QWidget*>(opacity_), static_cast<QWidget*>(onSlices_), static_cast<QWidget*>(only_),
                       static_cast<QWidget*>(all_), static_cast<QWidget*>(remove_)})
    one->setEnabled(row >= 0);
  if (row >= 0) {
    opacity_->setRange({0, kPercent, kPercent * defaultOpacity(label), 5, 0});
    opacity_->setValue(kPercent * shared_.appearance.look(label).opacity);
    onSlices_->setRange({0, kPercent, kPercent * defaultShareOnSlices(label), 5, 0});
    onSlices_->setValue(kPercent * shared_.appearance.look(label).onSlices);
  }
  showing_ = false;
}

bool StructureTable::eventFilter(QObject* watched, QEvent* event) {
  if (watched != table_ || event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
  const auto& pressed = *static_cast<QKeyEvent*>(event);
  const int key = pressed.key();
  const std::uint8_t label = shared_.structures.selected();
  if (key == Qt::Key_Space) {
    shared_.appearance.setVisible(label, !shared_.appearance.look(label).visible);
    return true;
  }
  // A tool in hand takes Enter: an author may select a label in the table just before applying the tool.
  if ((key == Qt::Key_Return || key == Qt::Key_Enter) && !commands_.key(pressed, false)) {
    chooseColor();
    return true;
  }
  return false;
}

}  // namespace insonate::prepare
