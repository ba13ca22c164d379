//! A small check of pages: every element is closed in order, and nothing is fetched from elsewhere.

const VOID: [&str; 4] = ["meta", "br", "hr", "img"];

/// Panics where elements are not closed in order, a `<` or `&` stands bare, or the page refers to anything outside itself.
pub fn check(page: &str) {
    assert!(page.starts_with("<!DOCTYPE html>"), "{}", &page[..page.len().min(60)]);
    for outside in ["http:", "https:", "//", "src=", "href=", "url(", "@import", "<script", "<link", "<iframe"] {
        let found = page.find(outside);
        // comments of rigs begin with two slashes, and may stand in a difference
        let body = |at: usize| outside == "//" && !page[..at].ends_with(['"', '\'', '(', ':']);
        assert!(found.is_none_or(body), "{outside}: {:?}", found.map(|at| page[at..].chars().take(60).collect::<String>()));
    }
    let mut open: Vec<String> = Vec::new();
    let mut rest = page;
    while let Some(at) = rest.find('<') {
        entities(&rest[..at], open.last().map_or("", String::as_str));
        rest = &rest[at..];
        let end = if rest.starts_with("<!--") { rest.find("-->").map(|e| e + 2) } else { rest.find('>') };
        let end = end.unwrap_or_else(|| panic!("a tag without end: {}", rest.chars().take(60).collect::<String>()));
        let tag = &rest[1..end];
        rest = &rest[end + 1..];
        if tag.starts_with('!') {
            continue;
        }
        if let Some(name) = tag.strip_prefix('/') {
            assert_eq!(open.pop().as_deref(), Some(name), "closed in order");
            continue;
        }
        assert_eq!(tag.matches('"').count() % 2, 0, "attributes are quoted: {tag}");
        let name = tag.split([' ', '/']).next().unwrap_or_default().to_owned();
        assert!(!name.is_empty() && name.chars().all(|c| c.is_ascii_alphanumeric()), "a bare <: {tag}");
        if !VOID.contains(&name.as_str()) {
            open.push(name);
        }
    }
    assert!(open.is_empty(), "not closed: {open:?}");
}

fn entities(text: &str, within: &str) {
    if within == "style" {
        return;
    }
    for (at, _) in text.match_indices('&') {
        let known = ["&amp;", "&lt;", "&gt;", "&quot;"].iter().any(|e| text[at..].starts_with(e));
        assert!(known, "a bare &: {}", text[at..].chars().take(20).collect::<String>());
    }
}
