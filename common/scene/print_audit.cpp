#include "common/scene/print_audit.h"

#include "common/scene/scene_names.h"

#include <algorithm>
#include <cctype>

namespace hipmap {

namespace {

/// A sentence around a quoted name: "material 'a' is black".
struct NamedSentence {
    std::string whole;
    std::string before, after; ///< with neither quote
    std::vector<std::string> names;
};

bool is_letter(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) != 0;
}

/// Quotes begin after a blank and end before anything but a letter, which apostrophes do not.
NamedSentence take_apart(const std::string& sentence)
{
    NamedSentence out = {sentence, sentence, "", {}};
    const std::size_t open = sentence.find(" '");
    if (open == std::string::npos)
        return out;
    std::size_t close = sentence.find('\'', open + 2);
    while (close != std::string::npos && close + 1 < sentence.size() &&
           is_letter(sentence[close + 1]))
        close = sentence.find('\'', close + 1);
    if (close == std::string::npos)
        return out;
    out.before = sentence.substr(0, open + 1);
    out.after = sentence.substr(close + 1);
    out.names = {sentence.substr(open + 2, close - open - 2)};
    return out;
}

/// The sentences that were not told yet; notes them as told.
std::vector<std::string> news(const std::vector<std::string>& sentences,
                              std::set<std::string>* told)
{
    std::vector<std::string> out;
    for (const std::string& sentence : sentences)
        if (told == nullptr || told->insert(sentence).second)
            out.push_back(sentence);
    return out;
}

void print_found(Report& report, const std::vector<std::string>& found)
{
    std::string all;
    for (const std::string& sentence : found) {
        if (report.verbose())
            report.line("scene: " + sentence);
        all += (all.empty() ? "" : "; ") + sentence;
    }
    if (!report.verbose() && !all.empty())
        report.line("scene: " + all);
}

} // namespace

std::vector<std::string> join_by_name(const std::vector<std::string>& sentences)
{
    std::vector<NamedSentence> parts;
    for (const std::string& sentence : sentences) {
        const NamedSentence next = take_apart(sentence);
        const auto same = std::find_if(parts.begin(), parts.end(), [&](const NamedSentence& one) {
            return !next.names.empty() && one.before == next.before && one.after == next.after;
        });
        if (same == parts.end())
            parts.push_back(next);
        else
            same->names.push_back(next.names[0]);
    }
    std::vector<std::string> out;
    for (const NamedSentence& part : parts)
        out.push_back(part.names.size() < 2 ? part.whole
                                            : part.before + list_names(part.names) + part.after);
    return out;
}

void print_audit(Report& report, const SceneAudit& audit, std::set<std::string>* told)
{
    const auto shown = [&](const std::vector<std::string>& sentences) {
        std::vector<std::string> fresh = news(sentences, told);
        return report.verbose() ? fresh : join_by_name(fresh);
    };
    const bool first = told == nullptr || told->empty();
    if (first || report.verbose()) // later frames differ in their moment alone
        print_found(report, shown(audit.found));
    for (const std::string& sentence : shown(audit.assumed))
        report.line("assumed: " + sentence);
    for (const std::string& sentence : shown(audit.warnings))
        report.warn(sentence);
}

} // namespace hipmap
