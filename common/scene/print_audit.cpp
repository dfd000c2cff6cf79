#include "common/scene/print_audit.h"

namespace hipmap {

void print_audit(Report& report, const SceneAudit& audit)
{
    for (const std::string& sentence : audit.found)
        report.line("scene: " + sentence);
    for (const std::string& sentence : audit.assumed)
        report.line("assumed: " + sentence);
    for (const std::string& sentence : audit.warnings)
        report.warn(sentence);
}

} // namespace hipmap
