#pragma once

#include <QWidget>
#include <functional>
#include <vector>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace insonate::prepare {

class PrepareSession;
class ToolSession;

/// The tool in hand, and nothing of others: what to do, its parameters, preview and apply.
class ToolPanel : public QWidget {
 public:
  ToolPanel(PrepareSession& session, ToolSession& tools, QWidget* parent = nullptr);

 private:
  void build();
  void refresh();

  PrepareSession& session_;
  ToolSession& tools_;
  QLabel *label_, *advice_;
  QPushButton *preview_, *apply_, *leave_;
  QWidget* fields_ = nullptr;
  QVBoxLayout* box_;
  std::vector<std::function<void()>> shown_;  ///< bring the fields up to date
  bool showing_ = false;
};

}  // namespace insonate::prepare
