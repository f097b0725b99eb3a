// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "jsontext.h"

#include <array>
#include <charconv>
#include <format>

#include "core/text/unicode.h"

namespace romanesco {

std::string jsonString(std::string_view text)
{
    std::string json = "\"";
    while (!text.empty()) {
        const CodePoint point = firstCodePoint(text);
        const std::string_view bytes = text.substr(0, point.length);
        text.remove_prefix(point.length);
        if (!point.isValid) {
            json += "\xEF\xBF\xBD";
        } else if (point.value < U' ') {
            json += std::format("\\u{:04x}", static_cast<unsigned>(point.value));
        } else {
            json += bytes == "\"" || bytes == "\\" ? "\\" : "";
            json += bytes;
        }
    }
    return json + '"';
}

std::string jsonNumber(double value)
{
    std::array<char, 32> text;
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string jsonNumbers(std::span<const double> values)
{
    std::string json = "[";
    for (const double value : values) {
        json += (json.size() > 1 ? "," : "") + jsonNumber(value);
    }
    return json + "]";
}

std::string jsonArray(std::span<const std::string> values)
{
    std::string json = "[";
    for (const std::string &value : values) {
        json += (json.size() > 1 ? "," : "") + value;
    }
    return json + "]";
}

}
