// The smaller build of the package; types are declared for the default one only.
declare module 'rhino3dm/rhino3dm.module.min.js' {
  export { default } from 'rhino3dm';
}
