#include "DeviceList.h"

#include "HandSection.h"

#include <insonate/haptics/ReportRecording.h>
#include <insonate/haptics/SimulatedDevice.h>
#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

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

constexpr int kMaxEvents = 200, kTableColumns = 8, kTestColumn = kTableColumns - 1, kRow_px = 34, kTest_ms = 3000;
constexpr double kTestForce_N = 0.8;

QString deviceText(const std::string& words) {
  return QString::fromStdString(words);
}

QString limitsOf(const DeviceLimits& limits) {
  if (limits.sensedAxes == 0) return DeviceList::tr("buttons");
  QString axes = DeviceList::tr("%1 axes").arg(limits.sensedAxes);
  if (limits.forceAxes == 0) return axes;
  return limits.maxStiffness_Npmm > 0
             ? DeviceList::tr("%1, %2 N, %3 N/mm").arg(axes).arg(limits.maxForce_N).arg(limits.maxStiffness_Npmm)
             : DeviceList::tr("%1, %2 N").arg(axes).arg(limits.maxForce_N);
}

QString latencyText(const DeviceQuality& quality) {
  return quality.latency_ms > 0 ? DeviceList::tr("%1 ms").arg(quality.latency_ms, 0, 'f', 0) : DeviceList::tr("-");
}

QString qualityText(const DeviceQuality& quality) {
  constexpr double kGood = 0.75, kFair = 0.4;
  if (quality.quality <= 0) return DeviceList::tr("not seen");
  return quality.quality >= kGood   ? DeviceList::tr("good")
         : quality.quality >= kFair ? DeviceList::tr("fair")
                                    : DeviceList::tr("poor");
}

}  // namespace

DeviceList::DeviceList(HapticControl& hands, QWidget* parent) : QWidget(parent), hands_(hands) {
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kSmallGap);
  auto* heading = new QLabel(tr("Devices"));
  ui::setRole(heading, "heading");
  box->addWidget(heading);
  table_ = new QTableWidget(0, kTableColumns, this);
  table_->setObjectName("deviceTable");
  table_->setAccessibleName(tr("Devices"));
  table_->setHorizontalHeaderLabels({tr("device"), tr("state"), tr("moves"), tr("updates/s"), tr("latency"),
                                     tr("quality"), tr("capabilities"), tr("test")});
  table_->setToolTip(
      tr("A new device appears in the list within a second. Latency: time from your motion until the program has it. "
         "Capabilities: number of axes, and maximum force and stiffness according to the manufacturer"));
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setTabKeyNavigation(false);
  table_->setMinimumHeight(150);
  table_->verticalHeader()->setDefaultSectionSize(kRow_px);
  none_ =
      new QLabel(tr("No device is connected; probe and needle are moved with mouse and keys. Connect a device, or add "
                    "a simulated device."));
  none_->setObjectName("noDevices");
  none_->setWordWrap(true);
  none_->setAlignment(Qt::AlignHCenter | Qt::AlignBottom);
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

void DeviceList::addButtons(const std::vector<QWidget*>& buttons) {
  auto* all = new QWidget;
  auto* row = new QHBoxLayout(all);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(ui::kGap);
  for (QWidget* one : buttons) row->addWidget(one);
  row->addStretch(1);
  layout()->addWidget(all);
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

/// Returns the tools that a device moves; an empty id means mouse and keys.
QString DeviceList::toolsOf(const QString& id) const {
  QStringList tools;
  if (hands_.choice().device(kProbeTool) == id) tools << tr("probe");
  if (hands_.choice().device(kNeedleTool) == id) tools << tr("needle");
  if (!id.isEmpty() && hands_.choice().pedal() == id) tools << tr("pedal");
  return tools.isEmpty() ? tr("-") : tools.join(tr(", "));
}

DeviceList::Row DeviceList::mouseRow(const QHash<QString, double>& rates_Hz) const {
  double rate_Hz = 0;
  DeviceQuality quality;
  bool isUsed = false;
  for (const HapticTool hand : {kProbeTool, kNeedleTool}) {
    if (!hands_.session().isMouseAssigned(hand)) continue;
    const auto device = hands_.session().assignedDevice(hand);
    rate_Hz = std::max(rate_Hz, rates_Hz.value(deviceText(device->info().id)));
    quality = device->quality();
    isUsed = true;
  }
  return {{},
          {tr("Mouse and keys"), isUsed ? displayText(DevicePhase::kStreaming) : displayText(DevicePhase::kReady),
           toolsOf({}), QString::number(rate_Hz, 'f', 0), latencyText(quality), tr("good"), tr("always there")},
          tr("Mouse and keys move every tool to which no device is assigned")};
}

DeviceList::Row DeviceList::rowOf(const HapticDevice& device, double rate_Hz) const {
  const QString id = deviceText(device.info().id), error = deviceText(device.error());
  const DeviceQuality quality = device.quality();
  const bool isMeasured = device.phase() == DevicePhase::kStreaming;
  const QString advice = deviceText(quality.advice);
  return {id,
          {deviceText(device.info().name), displayText(device.phase()), toolsOf(id), QString::number(rate_Hz, 'f', 0),
           isMeasured ? latencyText(quality) : tr("-"), isMeasured ? qualityText(quality) : tr("-"),
           limitsOf(device.info().limits)},
          !error.isEmpty()   ? error
          : advice.isEmpty() ? id
                             : advice,
          !error.isEmpty() || (isMeasured && !advice.isEmpty())};
}

void DeviceList::refresh(const QHash<QString, double>& rates_Hz) {
  auto devices = hands_.session().devices().devices();
  // The halves of a controller exist before one is connected.
  std::erase_if(devices, [](const auto& device) {
    return device->info().kind == DeviceKind::kController && device->phase() == DevicePhase::kAbsent;
  });
  table_->setRowCount(1 + int(devices.size()));
  none_->setVisible(devices.empty());
  show(0, mouseRow(rates_Hz));
  for (int n = 0; n < int(devices.size()); ++n) {
    const HapticDevice& device = *devices[std::size_t(n)];
    show(n + 1, rowOf(device, rates_Hz.value(deviceText(device.info().id))));
  }
  if (test_) goOnTesting();
  refreshPedals();
}

void DeviceList::show(int at, const Row& row) {
  for (int column = 0; column < kTestColumn; ++column) {
    QTableWidgetItem* item = table_->item(at, column);
    if (!item) table_->setItem(at, column, item = new QTableWidgetItem);
    if (item->text() != row.cells[column]) item->setText(row.cells[column]);
    item->setToolTip(row.tip);
    item->setIcon(column == 1 && row.hasProblem ? ui::icon("warning", views::theme::kCaution) : QIcon());
  }
  auto* test = qobject_cast<QPushButton*>(table_->cellWidget(at, kTestColumn));
  if (!test) {
    test = ui::pushButton("testDevice", tr("Test"), tr("Says for three seconds how the device reports your motion"),
                          Qt::TabFocus);
    connect(test, &QPushButton::clicked, this, [this, test] { beginTest(test->property("device").toString()); });
    table_->setCellWidget(at, kTestColumn, test);
  }
  test->setProperty("device", row.id);
  test->setEnabled(!test_);
}

quint64 DeviceList::reportsOf(const QString& id) const {
  if (const auto device = id.isEmpty() ? nullptr : hands_.deviceOf(id)) return device->counters().reports;
  quint64 reports = 0;
  for (const HapticTool hand : {kProbeTool, kNeedleTool})
    if (hands_.session().isMouseAssigned(hand)) reports += hands_.session().assignedDevice(hand)->counters().reports;
  return reports;
}

void DeviceList::beginTest(const QString& id) {
  const auto device = id.isEmpty() ? nullptr : hands_.deviceOf(id);
  test_ = Test{id, device ? deviceText(device->info().name) : tr("Mouse and keys"), reportsOf(id), {}, {}, {}};
  test_->since.start();
  tell(tr("%1: move it for three seconds.").arg(test_->name), false);
  for (const HapticTool hand : {kProbeTool, kNeedleTool})
    if (device && device->info().limits.forceAxes > 0 && hands_.choice().device(hand) == id)
      hands_.session().testForce(hand, {0, kTestForce_N, 0});
}

void DeviceList::goOnTesting() {
  const ServoSnapshot now = hands_.session().snapshot();
  for (const HapticTool hand : {kProbeTool, kNeedleTool}) {
    const bool isMouse = test_->id.isEmpty() && hands_.session().isMouseAssigned(hand);
    if (!now.present[hand] || !(isMouse || (!test_->id.isEmpty() && hands_.choice().device(hand) == test_->id)))
      continue;
    const Vec3 at_mm = now.states[hand].deviceFromStylus.offset;
    if (!test_->least_mm) test_->least_mm = test_->most_mm = at_mm;
    for (int axis = 0; axis < 3; ++axis) {
      (*test_->least_mm)[axis] = std::min((*test_->least_mm)[axis], at_mm[axis]);
      (*test_->most_mm)[axis] = std::max((*test_->most_mm)[axis], at_mm[axis]);
    }
  }
  if (test_->since.elapsed() < kTest_ms) return;
  const double reports = double(reportsOf(test_->id) - test_->reports) * 1000 / double(test_->since.elapsed());
  if (reports < 1)
    tell(tr("%1: no motion was reported. Check that it is connected, and that a tool is assigned to it.")
             .arg(test_->name),
         true);
  else if (test_->least_mm)
    tell(tr("%1: %2 updates per second; moved by %3 mm.")
             .arg(test_->name)
             .arg(reports, 0, 'f', 0)
             .arg(norm(*test_->most_mm - *test_->least_mm), 0, 'f', 0),
         false);
  else
    tell(tr("%1: %2 updates per second.").arg(test_->name).arg(reports, 0, 'f', 0), false);
  test_.reset();
}

}  // namespace insonate::train
