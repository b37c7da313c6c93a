// What this browser keeps for the page; one that keeps nothing for a page from disk does no harm.

export function keep(name, text) {
  try {
    localStorage.setItem(name, text);
  } catch {
    // kept as long as the page is open
  }
}

export function kept(name) {
  try {
    return localStorage.getItem(name);
  } catch {
    return null;
  }
}
