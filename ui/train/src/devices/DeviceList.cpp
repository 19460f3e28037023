#include "DeviceList.h"

#include "HandSection.h"

#include <insonate/haptics/ReportRecording.h>
#include <insonate/haptics/SimulatedDevice.h>
#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>

#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QTime>
#include <QVBoxLayout>
#include <algorithm>

namespace insonate::train {
namespace {

constexpr int kMaxEvents = 200;

QString deviceText(const std::string& words) {
  return QString::fromStdString(words);
}

QString limitsOf(const DeviceLimits& limits) {
  if (limits.sensedAxes == 0) return DeviceList::tr("buttons");
  const QString axes = DeviceList::tr("%1 axes").arg(limits.sensedAxes);
  if (limits.forceAxes == 0) return axes;
  return limits.maxStiffness_Npmm > 0
             ? DeviceList::tr("%1, %2 N, %3 N/mm").arg(axes).arg(limits.maxForce_N).arg(limits.maxStiffness_Npmm)
             : DeviceList::tr("%1, %2 N").arg(axes).arg(limits.maxForce_N);
}

}  // namespace

DeviceList::DeviceList(HapticControl& hands, QWidget* parent) : QWidget(parent), hands_(hands) {
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kSmallGap);
  auto* heading = new QLabel(tr("Devices"));
  ui::setRole(heading, "heading");
  box->addWidget(heading);
  table_ = new QTableWidget(0, 4, this);
  table_->setObjectName("deviceTable");
  table_->setAccessibleName(tr("Devices"));
  table_->setHorizontalHeaderLabels({tr("device"), tr("state"), tr("capabilities"), tr("updates/s")});
  table_->setToolTip(
      tr("A new device appears in the list within a second. Capabilities: number of axes, and maximum force and "
         "stiffness according to the manufacturer"));
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setTabKeyNavigation(false);
  table_->setMinimumHeight(110);
  none_ =
      new QLabel(tr("No device is connected; probe and needle are moved with mouse and keys. Connect a device, or add "
                    "a simulated device."));
  none_->setObjectName("noDevices");
  none_->setWordWrap(true);
  none_->setAlignment(Qt::AlignCenter);
  ui::setRole(none_, "quiet");
  (new QVBoxLayout(table_->viewport()))->addWidget(none_);
  box->addWidget(table_, 2);
  box->addWidget(buildButtons());
  events_ = new QListWidget(this);
  events_->setObjectName("deviceEvents");
  events_->setAccessibleName(tr("Device events"));
  events_->setWordWrap(true);
  events_->setMinimumHeight(60);
  box->addWidget(events_, 1);
  connect(&hands_, &HapticControl::deviceEvent, this,
          [this](const DeviceEvent& event) { tell(deviceText(event.text), event.error); });
}

QWidget* DeviceList::buildButtons() {
  auto* all = new QWidget;
  auto* row = new QHBoxLayout(all);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(ui::kGap);
  auto* pedalName = new QLabel(tr("pedal"));
  ui::setRole(pedalName, "quiet");
  pedal_ = new QComboBox;
  pedal_->setObjectName("pedal");
  pedal_->setAccessibleName(tr("Pedal"));
  pedal_->setToolTip(tr("Pedal whose first button freezes and unfreezes the image"));
  pedal_->setFocusPolicy(Qt::TabFocus);
  connect(pedal_, qOverload<int>(&QComboBox::activated), this,
          [this] { hands_.assignPedal(pedal_->currentData().toString()); });
  auto* simulated = new QPushButton(tr("Add simulated device"));
  simulated->setObjectName("addSimulated");
  simulated->setToolTip(
      tr("Adds a simulated device that you move with mouse and keys; the computed forces displace it"));
  auto* menu = new QMenu(simulated);
  for (std::size_t n = 0; n < deviceProfiles().size(); ++n) {
    const std::string_view name = deviceProfiles()[n].name;
    connect(menu->addAction(ui::qt(name)), &QAction::triggered, this, [this, n] { addSimulated(int(n)); });
  }
  simulated->setMenu(menu);
  auto* replayed = new QPushButton(tr("Replay ..."));
  replayed->setObjectName("replayReports");
  replayed->setToolTip(tr("Replays recorded device data in a loop, as if from a connected device"));
  connect(replayed, &QPushButton::clicked, this, [this] {
    const QString file = QFileDialog::getOpenFileName(this, tr("Recorded device data"));
    if (!file.isEmpty()) replay(file.toStdString());
  });
  record_ = new QPushButton(tr("Record ..."));
  record_->setObjectName("recordReports");
  record_->setCheckable(true);
  record_->setToolTip(tr("Records the raw data of all connected devices to a file, for replay or troubleshooting"));
  connect(record_, &QPushButton::clicked, this, [this](bool on) {
    const QString file = on ? QFileDialog::getSaveFileName(this, tr("Record device data"), "reports.txt") : QString();
    record_->setChecked(record(file.toStdString()) && !file.isEmpty());
  });
  for (QPushButton* one : {simulated, replayed, record_}) {
    one->setFocusPolicy(Qt::TabFocus);
    one->setAutoDefault(false);  // Enter is the number's that is typed
  }
  row->addWidget(pedalName);
  row->addWidget(pedal_, 1);
  row->addWidget(simulated);
  row->addWidget(replayed);
  row->addWidget(record_);
  return all;
}

void DeviceList::addSimulated(int profile) {
  const std::string id = "simulated:" + std::string(deviceProfiles()[profile].name) + "#" + std::to_string(++made_);
  hands_.session().devices().add(
      std::make_shared<SimulatedDevice>(id, deviceProfiles()[profile], Grip{}, HandPath::Point{}));
  hands_.checkDevices();
  Q_EMIT hands_.handsChanged();
}

void DeviceList::replay(const std::filesystem::path& file) {
  const auto reports = readRecording(file);
  auto device = reports ? replayRecording(*reports, {}, true)
                        : Result<std::shared_ptr<HapticDevice>>(tl::unexpected(reports.error()));
  if (!device) return tell(deviceText(device.error().message), true);
  hands_.session().devices().add(std::move(*device));
  hands_.checkDevices();
  Q_EMIT hands_.handsChanged();
}

bool DeviceList::record(const std::filesystem::path& file) {
  ReportRecorder& recorder = hands_.session().devices().recorder();
  if (file.empty() && !recorder.isRunning()) return true;
  const auto done = file.empty() ? recorder.stop() : recorder.start(file);
  if (!done)
    tell(deviceText(done.error().message), true);
  else
    tell(file.empty() ? tr("The recording of device data was saved.")
                      : tr("Device data are being recorded to %1.").arg(deviceText(file.string())),
         false);
  return done.has_value();
}

void DeviceList::tell(const QString& sentence, bool error) {
  auto* item = new QListWidgetItem(QTime::currentTime().toString("HH:mm:ss  ") + sentence);
  if (error) item->setIcon(ui::icon("warning", views::theme::kCaution));
  events_->insertItem(0, item);
  while (events_->count() > kMaxEvents) delete events_->takeItem(events_->count() - 1);
}

void DeviceList::refreshPedals() {
  QStringList ids{QString()};
  for (const auto& device : hands_.session().devices().devices())
    if (device->info().kind == DeviceKind::kPedal) ids << deviceText(device->info().id);
  if (!ids.contains(hands_.choice().pedal())) ids << hands_.choice().pedal();
  QStringList shown;
  for (int n = 0; n < pedal_->count(); ++n) shown << pedal_->itemData(n).toString();
  const QSignalBlocker quiet(pedal_);
  if (shown != ids) {
    pedal_->clear();
    for (const QString& id : ids) {
      const auto device = hands_.deviceOf(id);
      pedal_->addItem(id.isEmpty() ? tr("none")
                      : device     ? deviceText(device->info().name)
                                   : tr("%1 (not connected)").arg(id),
                      id);
    }
  }
  pedal_->setCurrentIndex(std::max(0, pedal_->findData(hands_.choice().pedal())));
}

void DeviceList::refresh(const QHash<QString, double>& rates_Hz) {
  const auto devices = hands_.session().devices().devices();
  table_->setRowCount(int(devices.size()));
  none_->setVisible(devices.empty());
  for (int row = 0; row < int(devices.size()); ++row) {
    const HapticDevice& device = *devices[row];
    const QString error = deviceText(device.error());
    const QString cells[] = {deviceText(device.info().name), displayText(device.phase()),
                             limitsOf(device.info().limits),
                             QString::number(rates_Hz.value(deviceText(device.info().id)), 'f', 0)};
    for (int column = 0; column < 4; ++column) {
      QTableWidgetItem* item = table_->item(row, column);
      if (!item) table_->setItem(row, column, item = new QTableWidgetItem);
      if (item->text() != cells[column]) item->setText(cells[column]);
      item->setToolTip(error.isEmpty() ? deviceText(device.info().id) : error);
      const bool faulty = column == 1 && !error.isEmpty();
      item->setIcon(faulty ? ui::icon("warning", views::theme::kCaution) : QIcon());
    }
  }
  refreshPedals();
}

}  // namespace insonate::train
