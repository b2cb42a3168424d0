// SPDX-License-Identifier: Apache-2.0
// Begins when the page is there: the theme, the plan, and the unit that the link names.
{
  const nav = document.querySelector('nav');
  const root = document.documentElement;
  const isDark = () => (root.dataset.theme ?? (matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light')) === 'dark';
  const changed = () => document.dispatchEvent(new CustomEvent('ilot:theme'));
  if (nav) {
    const button = ilot.make('button', { textContent: isDark() ? 'light' : 'dark', title: 'light or dark' });
    button.onclick = () => {
      root.dataset.theme = isDark() ? 'light' : 'dark';
      button.textContent = isDark() ? 'light' : 'dark';
      changed();
    };
    nav.append(button);
  }
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', changed);
  // On paper everything is light, and the plan is drawn finer.
  let themeBefore;
  addEventListener('beforeprint', () => {
    themeBefore = root.dataset.theme;
    root.dataset.theme = 'light';
    if (ilot.plan) ilot.plan.printing = true;
    changed();
    ilot.plan?.draw();
    // A canvas loses its content when paper gives it another size: pictures of them are printed.
    for (const canvas of document.querySelectorAll('main canvas')) {
      const picture = ilot.make('img', { className: 'on-paper', alt: canvas.getAttribute('aria-label') ?? '', src: canvas.toDataURL('image/png') });
      canvas.before(picture);
    }
  });
  addEventListener('afterprint', () => {
    if (themeBefore === undefined) delete root.dataset.theme; else root.dataset.theme = themeBefore;
    if (ilot.plan) ilot.plan.printing = false;
    for (const picture of document.querySelectorAll('img.on-paper')) picture.remove();
    changed();
  });
  if (document.getElementById('unit')) {
    const parsed = document.readyState === 'loading' ? new Promise((done) => addEventListener('DOMContentLoaded', done)) : null;
    ilot.started = (async () => {
      await parsed;
      if (typeof DecompressionStream === 'undefined') {
        for (const place of document.querySelectorAll('.plan, #viewer'))
          place.replaceChildren(ilot.make('p', { className: 'note', textContent: 'This browser is too old for the plan and the view; those of 2023 and later show them.' }));
        return;
      }
      await ilot.startPlan();
      if (ilot.startViewer && document.getElementById('viewer')) await ilot.startViewer();
      await ilot.follow(true);
    })();
    addEventListener('hashchange', () => ilot.follow(false));
  } else if (location.hash) ilot.follow(false);
}
