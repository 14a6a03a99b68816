#include "core/vehicle/checklist.h"

#include "core/vehicle/text_fields.h"

#include <algorithm>

namespace skyseal::vehicle {

namespace {

/// `line` is not empty, and part of `whole`, the line as it is in the file.
ChecklistItem parseItem(std::string_view line, std::string_view whole, std::vector<InputError> &problems)
{
    const std::size_t open = line.back() == ']' ? line.rfind('[') : std::string_view::npos;
    ChecklistItem item;
    item.text = std::string(trimmed(line.substr(0, open)));
    if (open == std::string_view::npos)
        return item;
    const std::string_view condition = line.substr(open + 1, line.size() - open - 2);
    const auto column = static_cast<std::size_t>(condition.data() - whole.data()) + 1;
    auto parsed = parseCondition(condition, column);
    if (item.text.empty()) {
        problems.push_back({sentence("Reason", "expected the text of the item before the condition"), {}, 0, 1});
        item.text = std::string(line);
    } else if (parsed) {
        item.condition = std::move(*parsed);
        item.conditionText = std::string(trimmed(condition));
    } else {
        problems.push_back(std::move(parsed.error()));
        item.text = std::string(line);
    }
    return item;
}

} // namespace

Result<Checklist, InputError> parseChecklist(std::string_view text, const std::string &source)
{
    const auto fail = [&source](const Reason &message, std::size_t line) {
        return tl::make_unexpected(InputError{message, source, line, 0});
    };
    if (text.size() > kMaxChecklistSize)
        return fail(sentence("Reason", "longer than %1 bytes")(kMaxChecklistSize), 0);
    text = withoutMark(text);
    Checklist out;
    std::size_t number = 0;
    while (!text.empty()) {
        const std::string_view whole = takeLine(text), line = trimmed(whole);
        ++number;
        if (std::ranges::any_of(line, [](char one) { return static_cast<unsigned char>(one) < 0x20 && one != '\t'; }))
            return fail(sentence("Reason", "a control character: this is not a text file"), number);
        if (line.empty() || line.front() == '#')
            continue;
        if (line.size() > kMaxChecklistItem)
            return fail(sentence("Reason", "an item longer than %1 bytes")(kMaxChecklistItem), number);
        if (out.items.size() == kMaxChecklistItems)
            return fail(sentence("Reason", "more than %1 items")(kMaxChecklistItems), number);
        const std::size_t before = out.problems.size();
        out.items.push_back(parseItem(line, whole, out.problems));
        for (std::size_t i = before; i < out.problems.size(); ++i) {
            out.problems[i].source = source;
            out.problems[i].line = number;
        }
    }
    if (out.items.empty())
        return fail(sentence("Reason", "no items"), 0);
    return out;
}

} // namespace skyseal::vehicle
