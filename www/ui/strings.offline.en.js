/** Texts about the copy of the page that the browser keeps. */
export const offlineText = {
  label: 'New version',
  ready: 'A new version of this page is ready.',
  elsewhere: 'This page was brought to a new version in another window. What you open next may be missing until you reload.',
  reload: 'Reload',
  later: 'Later',
};
