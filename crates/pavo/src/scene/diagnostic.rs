//! Errors of scenes as miette draws them.

use std::fmt;

use miette::{Diagnostic, LabeledSpan, MietteError, MietteSpanContents, SourceCode, SourceSpan, SpanContents};

use super::error::{SceneError, Source};

impl SourceCode for Source {
    fn read_span<'a>(
        &'a self,
        span: &SourceSpan,
        lines_before: usize,
        lines_after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let of_text = self.text.read_span(span, lines_before, lines_after)?;
        let (data, span) = (of_text.data(), *of_text.span());
        let (line, column, count) = (of_text.line(), of_text.column(), of_text.line_count());
        let named = MietteSpanContents::new_named(self.name.clone(), data, span, line, column, count);
        Ok(Box::new(named.with_language("toml")))
    }
}

impl Diagnostic for SceneError {
    fn code<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        Some(Box::new("pavo::scene"))
    }

    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        Some(Box::new(&self.detail.help))
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        self.detail.source.as_ref().filter(|_| self.detail.drawable).map(|source| source as &dyn SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        if !self.detail.drawable {
            return None;
        }
        let labels = self.detail.labels.iter().enumerate().map(|(index, (span, label))| {
            let text = Some(label.clone());
            if index == 0 {
                LabeledSpan::new_primary_with_span(text, span.clone())
            } else {
                LabeledSpan::new_with_span(text, span.clone())
            }
        });
        Some(Box::new(labels))
    }
}
