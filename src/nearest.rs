//! The nearest known name to a misspelt one, for "did you mean" in messages.

/// Returns the candidate with the fewest single-letter edits from `found`, if it is near enough to be meant:
/// at most a third of its letters. Ties go to the earlier candidate.
#[must_use]
pub fn nearest<'a>(found: &str, candidates: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    candidates
        .map(|candidate| (edits(found, candidate), candidate))
        .filter(|(edits, candidate)| *edits <= candidate.chars().count() / 3)
        .min_by_key(|(edits, _)| *edits)
        .map(|(_, candidate)| candidate)
}

/// Levenshtein distance: insertions, deletions and replacements of one letter.
fn edits(from: &str, to: &str) -> usize {
    let to: Vec<char> = to.chars().collect();
    let mut row: Vec<usize> = (0..=to.len()).collect();
    for (i, a) in from.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, &b) in to.iter().enumerate() {
            let replace = diagonal + usize::from(a != b);
            diagonal = row[j + 1];
            row[j + 1] = replace.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[to.len()]
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn a_slip_is_recognised_and_a_different_word_is_not() {
        let names = ["agents", "storage-threshold", "seed"];
        assert_eq!(nearest("agnets", names.into_iter()), Some("agents"));
        assert_eq!(nearest("storage-treshold", names.into_iter()), Some("storage-threshold"));
        assert_eq!(nearest("wheels", names.into_iter()), None);
    }
}
