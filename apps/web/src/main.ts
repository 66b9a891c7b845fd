import App from './App.svelte';
import './app.css';
import { show } from './show';

void show(App);
