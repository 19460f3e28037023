#include "Feature.h"

#include "../layout/PrepareLayout.h"
#include "../model/OpenCase.h"
#include "../model/PrepareModel.h"

#include <insonate/ui/Workspace.h>

#include <utility>

namespace insonate::prepare {

Feature::Feature(PrepareModel& model, PrepareLayout& layout)
    : QObject(&layout.workspace()), model_(model), layout_(layout) {}

ui::Commands& Feature::commands() {
  return layout_.workspace().commands();
}

void Feature::add(const char* id, const QString& listed, const QString& does, const Keys& keys,
                  std::function<bool()> isAvailable) {
  ui::Command command{.id = QLatin1String(id), .text = {}, .does = does, .listed = listed, .keys = {}, .perform = {}};
  for (const auto& [key, act] : keys) command.keys.push_back({key, {}, [act = act](ui::KeyPress) { act(); }});
  command.perform = command.keys.front().perform;
  command.isAvailable = [&openCase = model_.openCase, own = std::move(isAvailable)] {
    return openCase.patient() && (!own || own());
  };
  commands().add(std::move(command));
}

}  // namespace insonate::prepare
