#include "TrackerDialog.h"

#include "TrackerList.h"

#include <insonate/igtlink/LinkServer.h>
#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>
#include <QVBoxLayout>

namespace insonate::train {
namespace {

constexpr int kTrackers_ms = 500;

QString stateOf(const TrackerList::Entry& entry) {
  const auto device = entry.hand->device();
  if (device->phase() == DevicePhase::kStreaming) return TrackerDialog::tr("the tracker sees the tool");
  const std::string error = device->error();
  return error.empty() ? TrackerDialog::tr("connecting") : ui::qt(error);
}

QString rateOf(const TrackerList::Entry& entry) {
  double rate_Hz = 0;
  for (const LinkToolStatus& tool : entry.hand->status().tools)
    if (entry.tool.isEmpty() || tool.name == entry.tool.toStdString()) rate_Hz = std::max(rate_Hz, tool.rate_Hz);
  return QString::number(rate_Hz, 'f', 0);
}

}  // namespace

TrackerDialog::TrackerDialog(TrackerList& trackers, QWidget* parent) : QDialog(parent), trackers_(trackers) {
  setObjectName("trackerDialog");
  setWindowTitle(tr("Trackers"));
  resize(720, 420);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(ui::kLargeGap, ui::kLargeGap, ui::kLargeGap, ui::kLargeGap);
  column->setSpacing(ui::kGap);
  column->addWidget(ui::paragraph("trackerWords", "quiet",
                                  tr("A tracking program, such as PLUS, sends the poses of its tools by OpenIGTLink. "
                                     "An added tool is listed in the "
                                     "window Devices, where you assign it to probe or needle.")));
  column->addWidget(buildFields());
  table_ = ui::named(new QTableWidget(0, 4, this), "trackerTable", tr("Trackers"), tr("Tools that were added"));
  table_->setHorizontalHeaderLabels({tr("tool"), tr("address"), tr("poses/s"), tr("state")});
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setTabKeyNavigation(false);
  column->addWidget(table_, 1);
  column->addWidget(buildButtons());
  said_ = ui::paragraph("trackerSaid");
  column->addWidget(said_);
  connect(&timer_, &QTimer::timeout, this, [this] { refresh(); });
  connect(table_, &QTableWidget::itemSelectionChanged, this, [this] { enableButtons(); });
  refresh();
}

QWidget* TrackerDialog::buildFields() {
  host_ = ui::named(new QLineEdit("localhost"), "trackerHost", tr("Computer"),
                    tr("Name or address of the computer on which the tracking program runs"));
  port_ = ui::named(new QSpinBox, "trackerPort", tr("Port"), tr("TCP port of the tracking program"));
  port_->setRange(1, 65535);
  port_->setValue(kLinkPort);
  tool_ = ui::named(new QLineEdit, "trackerTool", tr("Tool"),
                    tr("Name under which the tracking program sends the tool, e.g. StylusToTracker"));
  tool_->setPlaceholderText(tr("first tool"));
  auto* add = ui::pushButton("addTracker", tr("Add Tracker"), tr("Connects to the tracking program"));
  connect(add, &QPushButton::clicked, this, [this] { this->add(); });
  auto* part = new QWidget;
  auto* row = new QHBoxLayout(part);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(ui::kGap);
  row->addWidget(host_, 2);
  row->addWidget(port_);
  row->addWidget(tool_, 2);
  row->addWidget(add);
  return part;
}

QWidget* TrackerDialog::buildButtons() {
  tip_ = ui::pushButton("trackerTip", tr("Calibrate Tip"),
                        tr("Finds the tip of the tool: pivot the tool about its tip in all directions for 15 seconds, "
                           "then press this button"));
  desk_ = ui::pushButton("trackerDesk", tr("Set Desk"),
                         tr("Finds the place of the desk: hold the probe still on its printed outline, with the "
                            "outline's arrow to your right, then press this button"));
  remove_ = ui::pushButton("removeTracker", tr("Remove"), tr("Disconnects the tool and removes it from the list"));
  connect(tip_, &QPushButton::clicked, this, [this] { calibrateTip(); });
  connect(desk_, &QPushButton::clicked, this, [this] { setDesk(); });
  connect(remove_, &QPushButton::clicked, this, [this] {
    trackers_.remove(selected());
    refresh();
  });
  auto* part = new QWidget;
  auto* row = new QHBoxLayout(part);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(ui::kGap);
  row->addStretch(1);
  for (QPushButton* one : {tip_, desk_, remove_}) row->addWidget(one);
  return part;
}

void TrackerDialog::add() {
  const QString host = host_->text().trimmed();
  if (host.isEmpty()) return said_->setText(tr("Enter the computer on which the tracking program runs."));
  const bool isAdded = trackers_.add(host, port_->value(), tool_->text().trimmed());
  said_->setText(isAdded ? tr("Assign the tool to probe or needle in the window Devices.")
                         : tr("This tool was added before. If you removed it, restart Insonate to add it again."));
  refresh();
  if (isAdded) table_->selectRow(table_->rowCount() - 1);
}

void TrackerDialog::calibrateTip() {
  const auto found = trackers_.entries()[std::size_t(selected())].hand->calibrateTip();
  if (!found) return said_->setText(ui::qt(found.error().message));
  said_->setText(tr("The tip is %1 mm from the marker's origin. It stayed in its place within %2 mm.")
                     .arg(norm(found->tip_body), 0, 'f', 1)
                     .arg(found->error_mm, 0, 'f', 2));
}

void TrackerDialog::setDesk() {
  const auto found = trackers_.entries()[std::size_t(selected())].hand->setDesk();
  said_->setText(found ? tr("The desk is set. The probe was still within %1 mm.").arg(found->spread_mm, 0, 'f', 2)
                       : ui::qt(found.error().message));
}

int TrackerDialog::selected() const {
  return table_->currentRow();
}

void TrackerDialog::refresh() {
  const auto& entries = trackers_.entries();
  table_->setRowCount(int(entries.size()));
  for (int row = 0; row < int(entries.size()); ++row) {
    const TrackerList::Entry& entry = entries[std::size_t(row)];
    const QString cells[] = {entry.tool.isEmpty() ? tr("first tool") : entry.tool,
                             QString("%1:%2").arg(entry.host).arg(entry.port), rateOf(entry), stateOf(entry)};
    for (int column = 0; column < 4; ++column) {
      QTableWidgetItem* item = table_->item(row, column);
      if (!item) table_->setItem(row, column, item = new QTableWidgetItem);
      if (item->text() != cells[column]) item->setText(cells[column]);
      item->setToolTip(cells[column]);
    }
  }
  enableButtons();
}

void TrackerDialog::enableButtons() {
  const bool isAny = selected() >= 0 && selected() < int(trackers_.entries().size());
  for (QPushButton* one : {tip_, desk_, remove_}) one->setEnabled(isAny);
}

void TrackerDialog::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  refresh();
  timer_.start(kTrackers_ms);
}

void TrackerDialog::hideEvent(QHideEvent* event) {
  timer_.stop();
  QDialog::hideEvent(event);
}

}  // namespace insonate::train
