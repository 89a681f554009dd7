#pragma once

namespace palpate::viewer {

// What a key or a button asks for.
enum class Command { kPause, kStep, kReset, kScreenshot, kExport, kGraphs, kRecord, kArm, kPanels, kQuit };

}  // namespace palpate::viewer
