#include "core/glsl/expression_depth.h"

#include "core/base/names.h"

#include <algorithm>
#include <string>
#include <vector>

namespace agaa {

namespace {

bool isLineEnd(char c) { return c == '\n' || c == '\r'; }

// Returns the text without escaped line breaks, which may be anywhere: in a comment, or between two signs of one token.
std::string joinedLines(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    for (size_t i = 0; i < text.size(); ++i)
        if (text[i] == '\\' && i + 1 < text.size() && isLineEnd(text[i + 1]))
            i += text.substr(i + 1).starts_with("\r\n") ? 2 : 1;
        else
            out += text[i];
    return out;
}

// Returns the length of the comment or space at the beginning of a text.
size_t skippedLength(std::string_view text) {
    size_t length = 0;
    if (text.starts_with("//")) {
        length = text.find_first_of("\n\r");
    } else if (text.starts_with("/*")) {
        const size_t end = text.find("*/", 2);
        length = end == std::string_view::npos ? end : end + 2;
    } else if (text[0] == ' ' || text[0] == '\t') {
        length = 1;
    }
    return std::min(length, text.size());
}

class Nesting {
public:
    void takeWord(std::string_view word) {
        endStatement(word == "else");
        // Statements follow keywords, brackets and each other without an operator: "if (a) if (b)", "else if".
        if (wasOperand_ || last_ == 'a')
            add();
        static constexpr std::string_view keywords[] = {"if", "else", "for", "while", "do", "switch", "return", "case"};
        wasOperand_ = std::find(std::begin(keywords), std::end(keywords), word) == std::end(keywords);
        last_ = 'a';
    }
    void takeSign(char sign) {
        if (sign == ';' || sign == '}') {
            if (sign == '}')
                pop();
            hasEnded_ = true;
        } else {
            endStatement(false);
            if (sign == '(' || sign == '[')
                push(wasOperand_); // arguments or an index
            else if (sign == '{')
                push(last_ == '=' || (last_ != ')' && levels_.back().isList));
            else if (sign == ')' || sign == ']')
                pop();
            else if (sign == ',' && levels_.back().isList)
                clear();
            else
                add();
        }
        wasOperand_ = sign == ')' || sign == ']';
        last_ = sign;
    }
    size_t deepest() const { return deepest_; }

private:
    struct Level {
        size_t operators = 0;
        bool isList = false; // its commas separate elements
    };

    void endStatement(bool isContinued) {
        if (hasEnded_ && !isContinued)
            clear();
        hasEnded_ = false;
    }
    void add() {
        ++levels_.back().operators;
        deepest_ = std::max(deepest_, ++depth_);
    }
    void clear() {
        depth_ -= levels_.back().operators;
        levels_.back().operators = 0;
    }
    void push(bool isList) {
        levels_.push_back({0, isList});
        deepest_ = std::max(deepest_, ++depth_);
    }
    void pop() {
        if (levels_.size() == 1)
            return;
        clear();
        levels_.pop_back();
        --depth_;
    }

    std::vector<Level> levels_ = {Level()};
    size_t depth_ = 0, deepest_ = 0;
    char last_ = 0;           // the last sign; 'a' for words
    bool wasOperand_ = false; // the last token ends an operand
    bool hasEnded_ = false;   // the last token ends a statement, unless "else" follows
};

} // namespace

size_t expressionDepth(std::string_view text) {
    const std::string joined = joinedLines(text);
    const std::string_view glsl = joined;
    Nesting code, directive;
    size_t deepest = 0;
    bool isDirective = false;
    for (size_t i = 0; i < glsl.size();) {
        Nesting& nesting = isDirective ? directive : code;
        if (const size_t skipped = skippedLength(glsl.substr(i)); skipped > 0) {
            i += skipped;
        } else if (isLineEnd(glsl[i])) {
            deepest = std::max(deepest, directive.deepest());
            directive = {};
            isDirective = false;
            ++i;
        } else if (isWordByte(glsl[i])) {
            const size_t begin = i;
            const bool isNumber = glsl[i] >= '0' && glsl[i] <= '9';
            while (i < glsl.size() && (isWordByte(glsl[i]) || (isNumber && glsl[i] == '.')))
                ++i;
            nesting.takeWord(glsl.substr(begin, i - begin));
        } else if (glsl[i] == '#') {
            isDirective = true;
            ++i;
        } else {
            nesting.takeSign(glsl[i++]);
        }
    }
    return std::max({deepest, directive.deepest(), code.deepest()});
}

} // namespace agaa
