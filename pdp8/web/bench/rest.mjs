// A screen that nobody attends: with ?rest=SECONDS the page begins afresh when it was not touched for so long.

export function rest() {
  const seconds = Number(new URLSearchParams(location.search).get("rest"));
  if (!(seconds > 0)) return;
  let timer;
  const touched = () => {
    clearTimeout(timer);
    timer = setTimeout(() => location.reload(), 1000 * seconds);
  };
  for (const kind of ["pointerdown", "pointermove", "wheel", "keydown"]) addEventListener(kind, touched, true);
  touched();
}
